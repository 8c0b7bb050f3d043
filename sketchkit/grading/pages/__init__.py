"""Pages that readers open in a browser: templates, the style and the script that they share."""
