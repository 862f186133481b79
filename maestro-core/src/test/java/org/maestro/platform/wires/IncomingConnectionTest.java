package org.maestro.platform.wires;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import jade.imtp.leap.JICP.JICPPacket;
import jade.imtp.leap.JICP.JICPProtocol;
import java.io.EOFException;
import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** What becomes of who connects to a container and is none. */
class IncomingConnectionTest {
  private ServerSocket server;
  private Socket stranger;
  private IncomingConnection connection;

  @BeforeEach
  void connect() throws IOException {
    server = new ServerSocket(0, 1, InetAddress.getLoopbackAddress());
    stranger = new Socket(server.getInetAddress(), server.getLocalPort());
    connection = new IncomingConnection(server.accept(), new Newcomers(1));
  }

  @AfterEach
  void disconnect() throws IOException {
    connection.close();
    stranger.close();
    server.close();
  }

  @Test
  void packetsComeAsTheyWereSent() throws IOException {
    JICPPacket sent =
        new JICPPacket(
            JICPProtocol.COMMAND_TYPE, JICPProtocol.DEFAULT_INFO, "whom", new byte[70_000]);
    sent.setSessionID((byte) 3);
    for (int time = 0; time < 2; time++) {
      Thread writer = new Thread(() -> write(sent));
      writer.start();
      JICPPacket read = connection.readPacket();
      assertThat(read.getType()).isEqualTo(JICPProtocol.COMMAND_TYPE);
      assertThat(read.getRecipientID()).isEqualTo("whom");
      assertThat(read.getSessionID()).isEqualTo((byte) 3);
      assertThat(read.getData()).hasSize(70_000);
    }
  }

  private void write(JICPPacket packet) {
    try {
      packet.writeTo(stranger.getOutputStream());
    } catch (IOException e) {
      throw new IllegalStateException(e);
    }
  }

  /** Half of them at a time would be too many for the open files that the process may have. */
  @Test
  void ofTwoThousandThatSayNothingFewStayAndWhoSpeaksIsHeard() throws IOException {
    Newcomers newcomers = new Newcomers(10);
    List<Socket> here = new ArrayList<>();
    List<Socket> there = new ArrayList<>();
    try {
      for (int number = 0; number < 2_000; number++) {
        there.add(new Socket(server.getInetAddress(), server.getLocalPort()));
        Socket accepted = server.accept();
        here.add(accepted);
        new IncomingConnection(accepted, newcomers);
        if (number % 100 == 99) {
          Socket host = new Socket(server.getInetAddress(), server.getLocalPort());
          there.add(host);
          IncomingConnection speaks = new IncomingConnection(server.accept(), newcomers);
          new JICPPacket(JICPProtocol.COMMAND_TYPE, JICPProtocol.DEFAULT_INFO, new byte[3])
              .writeTo(host.getOutputStream());
          assertThat(speaks.readPacket().getData()).hasSize(3);
          speaks.close();
        }
        while (there.size() > 20) {
          there.remove(0).close();
        }
      }
      assertThat(here.stream().filter(socket -> !socket.isClosed())).hasSizeBetween(1, 10);
    } finally {
      for (Socket socket : there) {
        socket.close();
      }
      for (Socket socket : here) {
        socket.close();
      }
    }
  }

  @Test
  void whoAnnouncesTwoGigabytesIsLetGo() throws IOException {
    stranger.getOutputStream().write(new byte[] {0, 8, -1, -1, -1, 127});
    assertIsLast(connection.readPacket());
  }

  @Test
  void soIsWhoDoesItLater() throws IOException {
    write(new JICPPacket(JICPProtocol.COMMAND_TYPE, JICPProtocol.DEFAULT_INFO, new byte[1]));
    assertThat(connection.readPacket().getData()).hasSize(1);
    stranger.getOutputStream().write(new byte[] {0, 8, 0, 0, 0, -128});
    assertThatThrownBy(() -> connection.readPacket())
        .isInstanceOf(IOException.class)
        .hasMessageContaining("2147483648 bytes");
  }

  @Test
  void whoGoesAtOnceLeavesNoTrace() throws IOException {
    stranger.close();
    assertIsLast(connection.readPacket());
    connection.close();
    assertThatThrownBy(() -> connection.readPacket()).isInstanceOf(EOFException.class);
  }

  private static void assertIsLast(JICPPacket packet) {
    assertThat(packet.getInfo() & JICPProtocol.TERMINATED_INFO).isNotZero();
    assertThat(packet.getRecipientID()).isNull();
  }
}
