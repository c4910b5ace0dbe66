3.1
of the crate with the macro
END
