3.1
A title
MESSAGE ”こんにちは”
END
