3.1
Full width space at the ends
　MESSAGE　立て　
END
