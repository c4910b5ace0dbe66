3.10   // the version
END of the world
REM one
END