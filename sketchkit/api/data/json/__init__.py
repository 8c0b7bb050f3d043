"""JSONObject and JSONArray."""
