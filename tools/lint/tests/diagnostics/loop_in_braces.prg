3.1
A title
loop {
  SLEEP 100
}
END
