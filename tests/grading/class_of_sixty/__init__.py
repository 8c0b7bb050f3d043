"""A class of sixty made submissions: right, wrong in each way, broken, and hostile."""
