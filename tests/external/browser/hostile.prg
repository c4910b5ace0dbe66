3.1
</title><script>alert(3)</script>
MESSAGE </script><script>alert(1)</script><img src=x onerror=alert(2)>
// </script><script>alert(4)</script>
SLEEP 200
EXIT
END
