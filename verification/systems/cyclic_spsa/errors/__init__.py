"""Where the error of one block settles, and the step that makes it smallest."""
