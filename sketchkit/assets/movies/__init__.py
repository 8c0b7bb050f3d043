"""Films: frames become an MP4, a GIF, a WebP or an animated PNG, one by one."""
