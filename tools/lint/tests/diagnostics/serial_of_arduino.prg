3.1
A title
Serial.println("hi");
END
