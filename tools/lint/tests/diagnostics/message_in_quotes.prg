3.1
A title
MESSAGE "ready"
END
