3.1
TITLE
!comment like Fortran
END
