package org.maestro.launch;

import static java.nio.charset.StandardCharsets.US_ASCII;

import java.io.ByteArrayOutputStream;
import java.io.DataOutputStream;
import java.io.File;
import java.io.IOException;
import java.io.InputStream;
import java.net.InetAddress;
import java.net.Socket;
import java.net.SocketException;
import java.net.SocketTimeoutException;
import java.net.URI;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Random;
import javax.tools.ToolProvider;
import org.maestro.fixtures.Gadgets;

/** Who has neither certificate nor token, and tries whatever there is at a port of another. */
final class Stranger {
  private static final byte COMMAND = 0;
  private static final byte WITH_DATA = 8;
  private static final byte SERIALIZABLE = 31;
  private static final int ANSWER_MILLIS = 5_000;

  /** Of a package that once was trusted by its name. */
  private static final String AGENT =
      """
      package jade.stranger;

      import jade.core.Agent;
      import jade.core.ContainerID;
      import java.nio.file.Files;
      import java.nio.file.Path;

      public class Mover extends Agent {
        private String witness;

        @Override
        protected void setup() {
          witness = (String) getArguments()[0];
          doMove(new ContainerID((String) getArguments()[1], null));
        }

        @Override
        protected void afterMove() {
          try {
            Files.writeString(Path.of(witness), "ran in " + ProcessHandle.current().pid());
          } catch (java.io.IOException e) {
            e.printStackTrace();
          }
        }
      }
      """;

  private final Path classes;

  private Stranger(Path classes) {
    this.classes = classes;
  }

  /**
   * @param directory in which he keeps an agent that nobody else knows
   */
  static Stranger in(Path directory) throws IOException {
    Path classes = Files.createDirectories(directory.resolve("foreign"));
    Path source = Files.createDirectories(directory.resolve("source")).resolve("Mover.java");
    Files.writeString(source, AGENT);
    int code =
        ToolProvider.getSystemJavaCompiler()
            .run(
                null,
                null,
                null,
                "-cp",
                System.getProperty("java.class.path"),
                "-proc:none",
                "-d",
                classes.toString(),
                source.toString());
    if (code != 0) {
      throw new AssertionError("The stranger's agent does not compile.");
    }
    return new Stranger(classes);
  }

  /**
   * Starts a plain JADE container that joins there, with an agent that moves on and then leaves a
   * witness that it has run.
   */
  JavaProcess joining(int port, String name, String destination, Path witness) throws IOException {
    return JavaProcess.startWith(
        classes,
        "jade.Boot",
        List.of(
            "-container",
            "-host",
            "127.0.0.1",
            "-port",
            String.valueOf(port),
            "-local-host",
            "127.0.0.1",
            "-container-name",
            name,
            "-services",
            "jade.core.mobility.AgentMobilityService",
            "%s-agent:jade.stranger.Mover(%s,%s)".formatted(name, witness, destination)));
  }

  /** Connects and says nothing. */
  static Socket silent(int port) throws IOException {
    return new Socket(InetAddress.getLoopbackAddress(), port);
  }

  /** Says what no protocol knows, or what announces more than comes. */
  static void rubbish(int port, Random random) throws IOException {
    for (int time = 0; time < 20; time++) {
      byte[] bytes = new byte[1 + random.nextInt(200)];
      random.nextBytes(bytes);
      if (time % 4 == 0) {
        bytes[0] = COMMAND;
      }
      say(port, bytes);
    }
    say(port, new byte[] {COMMAND, WITH_DATA, -1, -1, -1, 127});
    say(port, "GET / HTTP/1.1\r\n\r\n".getBytes(US_ASCII));
  }

  private static void say(int port, byte[] bytes) throws IOException {
    try (Socket socket = silent(port)) {
      socket.getOutputStream().write(bytes);
      socket.getOutputStream().flush();
    } catch (SocketException hungUp) {
      // That is one of the right answers.
    }
  }

  /** Objects that have been made in processes of open sites, or have kept a core for minutes. */
  static List<Object> gadgets() throws IOException {
    return List.of(
        new File("/"),
        URI.create("http://127.0.0.1/").toURL(),
        Gadgets.nest(32),
        new Object[] {Gadgets.nest(32)});
  }

  /**
   * Sends a command of JADE's with a serialised object. Whoever does not hang up answers in time.
   */
  static boolean serialised(int port, Object gadget) throws IOException {
    try (Socket socket = silent(port)) {
      socket.setSoTimeout(ANSWER_MILLIS);
      socket.getOutputStream().write(packet(gadget));
      socket.getOutputStream().flush();
      InputStream in = socket.getInputStream();
      if (in.read() >= 0) {
        in.readNBytes(in.available());
      }
      return true;
    } catch (SocketTimeoutException late) {
      return false;
    } catch (SocketException hungUp) {
      return true;
    }
  }

  private static byte[] packet(Object gadget) throws IOException {
    byte[] object = Gadgets.bytes(gadget);
    ByteArrayOutputStream command = new ByteArrayOutputStream();
    try (DataOutputStream out = new DataOutputStream(command)) {
      out.writeInt(1);
      out.writeInt(0);
      out.writeInt(1);
      out.writeBoolean(true);
      out.writeByte(SERIALIZABLE);
      out.writeInt(object.length);
      out.write(object);
    }
    ByteArrayOutputStream packet = new ByteArrayOutputStream();
    packet.write(COMMAND);
    packet.write(WITH_DATA);
    for (int place = 0; place < Integer.BYTES; place++) {
      packet.write(command.size() >> (place * Byte.SIZE));
    }
    command.writeTo(packet);
    return packet.toByteArray();
  }
}
