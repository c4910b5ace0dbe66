3.1
full width letters
ＳＬＥＥＰ 20
SLEEP ２０
END
