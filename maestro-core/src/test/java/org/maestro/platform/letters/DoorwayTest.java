package org.maestro.platform.letters;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.io.IOException;
import java.io.InputStream;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Before a reader that answers each line. */
class DoorwayTest {
  private static final InetAddress LOOPBACK = InetAddress.getLoopbackAddress();
  private static final int LIMIT_MILLIS = 20_000;

  private final AtomicLong heard = new AtomicLong();
  private ServerSocket reader;
  private Doorway doorway;

  @BeforeEach
  void open() throws IOException {
    reader = new ServerSocket(0, 8, LOOPBACK);
    Thread reading = new Thread(this::read, "reader");
    reading.setDaemon(true);
    reading.start();
    doorway = Doorway.open(LOOPBACK.getHostAddress(), 0, reader.getLocalPort());
  }

  @AfterEach
  void close() throws IOException {
    doorway.close();
    reader.close();
  }

  private void read() {
    while (!reader.isClosed()) {
      try (Socket socket = reader.accept()) {
        InputStream in = socket.getInputStream();
        for (int next = in.read(); next >= 0; next = in.read()) {
          heard.incrementAndGet();
          if (next == '\n') {
            socket.getOutputStream().write("heard\n".getBytes(StandardCharsets.US_ASCII));
          }
        }
      } catch (IOException e) {
        assertThat(e).as("the test is over, or the sender has gone").isNotNull();
      }
    }
  }

  /** More than one may be in all. */
  @Test
  void messagesAfterEachOtherAreHandedOnAndAnswered() throws IOException {
    byte[] message = new byte[600_000];
    message[message.length - 1] = '\n';
    try (Socket sender = sender()) {
      for (int number = 0; number < 3; number++) {
        sender.getOutputStream().write(message);
        assertThat(line(sender)).isEqualTo("heard");
      }
    }
    assertThat(heard).hasValue(3L * message.length);
  }

  @Test
  void aMessageThatIsTooLargeIsRefusedAndNotReadToItsEnd() throws IOException {
    byte[] piece = new byte[100_000];
    try (Socket sender = sender()) {
      boolean isRefused = false;
      for (int number = 0; number < 100 && !isRefused; number++) {
        try {
          sender.getOutputStream().write(piece);
        } catch (IOException e) {
          isRefused = true;
        }
      }
      assertThat(isRefused || sender.getInputStream().read() == 'H').isTrue();
    }
    assertThat(heard.get()).isLessThanOrEqualTo(Doorway.MOST_BYTES);
  }

  @Test
  void withItsEndNobodyIsLetInAndNobodyIsLeftHanging() throws IOException {
    try (Socket sender = sender()) {
      sender.getOutputStream().write("a\n".getBytes(StandardCharsets.US_ASCII));
      assertThat(line(sender)).isEqualTo("heard");
      doorway.close();
      await()
          .until(
              () -> {
                try {
                  return sender.getInputStream().read() < 0;
                } catch (IOException e) {
                  return true;
                }
              });
    }
  }

  private Socket sender() throws IOException {
    Socket socket = new Socket(LOOPBACK, doorway.port());
    socket.setSoTimeout(LIMIT_MILLIS);
    return socket;
  }

  private static String line(Socket socket) throws IOException {
    StringBuilder line = new StringBuilder();
    for (int next = socket.getInputStream().read(); next != '\n'; next = read(socket)) {
      line.append((char) next);
    }
    return line.toString();
  }

  private static int read(Socket socket) throws IOException {
    int next = socket.getInputStream().read();
    assertThat(next).as("the connection ended").isNotNegative();
    return next;
  }
}
