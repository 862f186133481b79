package org.maestro.platform.wires;

import jade.imtp.leap.JICP.JICPConnection;
import jade.imtp.leap.JICP.JICPPacket;
import jade.imtp.leap.JICP.JICPProtocol;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.io.SequenceInputStream;
import java.net.Socket;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * A connection that another has made, and who says nothing, or too much, is let go. JADE would wait
 * for ever, or make room for two gigabytes because somebody says that they come. For one thread.
 */
final class IncomingConnection extends JICPConnection {
  private static final Logger LOG = LoggerFactory.getLogger(IncomingConnection.class);
  private static final int FIRST_WITHIN_MILLIS = 10_000;
  private static final int MOST_BYTES = 16 << 20;
  private static final int SIZE_BYTES = 4;
  private static final int BYTE = 0xff;

  private final Newcomers newcomers;

  IncomingConnection(Socket socket, Newcomers newcomers) {
    super(socket);
    this.newcomers = newcomers;
    newcomers.enter(socket);
  }

  @Override
  public void close() throws IOException {
    Socket socket = sc;
    super.close();
    if (socket != null) {
      newcomers.leave(socket);
    }
  }

  /**
   * @return what came; after something that is no packet one that ends the connection, since JADE
   *     prints the trace of what is thrown here
   */
  @Override
  public JICPPacket readPacket() throws IOException {
    if (sc == null) {
      throw new EOFException("The connection is closed.");
    }
    if (is != null) {
      return bounded(is);
    }
    Socket socket = sc;
    try {
      newcomers.awaitEntry();
      is = socket.getInputStream();
      socket.setSoTimeout(FIRST_WITHIN_MILLIS);
      JICPPacket first = bounded(is);
      socket.setSoTimeout(0);
      return first;
    } catch (IOException none) {
      LOG.debug("{} connected and sent nothing that can be read", getRemote(socket), none);
      return new JICPPacket(JICPProtocol.RESPONSE_TYPE, JICPProtocol.TERMINATED_INFO, null);
    } finally {
      newcomers.leave(socket);
    }
  }

  private static String getRemote(Socket socket) {
    return String.valueOf(socket.getRemoteSocketAddress());
  }

  private static JICPPacket bounded(InputStream in) throws IOException {
    ByteArrayOutputStream head = new ByteArrayOutputStream();
    copy(in, head);
    int info = copy(in, head);
    if ((info & JICPProtocol.SESSION_ID_PRESENT_INFO) != 0) {
      copy(in, head);
    }
    if ((info & JICPProtocol.RECIPIENT_ID_PRESENT_INFO) != 0) {
      for (int rest = copy(in, head); rest > 0; rest--) {
        copy(in, head);
      }
    }
    if ((info & JICPProtocol.DATA_PRESENT_INFO) != 0) {
      long size = 0;
      for (int place = 0; place < SIZE_BYTES; place++) {
        size |= (long) copy(in, head) << (place * Byte.SIZE);
      }
      if (size > MOST_BYTES) {
        throw new IOException("A packet of %d bytes is announced, and refused.".formatted(size));
      }
    }
    return JICPPacket.readFrom(
        new SequenceInputStream(new ByteArrayInputStream(head.toByteArray()), in));
  }

  private static int copy(InputStream in, ByteArrayOutputStream head) throws IOException {
    int next = in.read();
    if (next < 0) {
      throw new EOFException("The connection has ended.");
    }
    head.write(next);
    return next & BYTE;
  }
}
