3.1
Key constants compare
KEY_IN
IF VAR_KEY == CHAR_Y GOTO YES:
EXIT
YES: END
