3.1
comments
// whole line ; FOO
SLEEP 20 // behind ; FOO
SLEEP 20// glued
  // indented
END // done
