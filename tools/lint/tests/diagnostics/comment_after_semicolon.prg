3.1
COMMENT
; a comment in assembler style
END
