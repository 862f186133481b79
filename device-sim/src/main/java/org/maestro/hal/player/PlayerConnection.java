package org.maestro.hal.player;

import java.io.BufferedInputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.time.Duration;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.maestro.hal.Twist;
import org.maestro.hal.wheels.Stance;
import org.maestro.ontology.floor.Point2;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The connection to the base of a robot that a Player server has. It connects again by itself when
 * it is lost. Only the last command counts: one that could not be sent in time is forgotten. Any
 * thread may call; none waits.
 */
public final class PlayerConnection implements AutoCloseable {
  private static final Logger LOG = LoggerFactory.getLogger(PlayerConnection.class);

  /** Of the server itself: to use a device; of a base: how it moves, and is to move. */
  private static final int USE_DEVICE = 3;

  private static final int STATE = 1;
  private static final int VELOCITY = 1;

  private static final int OPEN = 1;
  private static final int MOTORS_ON = 1;
  private static final Duration CONNECTS_WITHIN = Duration.ofSeconds(5);
  private static final Duration TRIES_AGAIN_AFTER = Duration.ofSeconds(1);

  /** A server that says nothing for so long is connected to anew. */
  private static final Duration GIVEN_UP_AFTER = Duration.ofSeconds(10);

  /** Servers tell poses ten times a second and more often. */
  private static final Duration LONGEST_SILENCE = Duration.ofSeconds(2);

  private final InetSocketAddress address;
  private final int index;
  private final BlockingQueue<Twist> command = new ArrayBlockingQueue<>(1);
  private final Thread reader;
  private final Thread writer;
  private volatile Optional<Socket> socket = Optional.empty();
  private volatile Optional<Told> told = Optional.empty();
  private volatile String missing;
  private final CountDownLatch end = new CountDownLatch(1);
  private volatile boolean closed;

  /**
   * What the server told last.
   *
   * @param odometry where the base is by its wheels, since this connection stands
   * @param connection which one, counted; odometry may begin anew with each
   */
  record Told(Stance odometry, boolean stalled, int connection, long atNanos) {}

  private PlayerConnection(InetSocketAddress address, int index) {
    this.address = address;
    this.index = index;
    this.missing = "has not answered yet";
    this.reader = thread(this::read, "player-reads");
    this.writer = thread(this::write, "player-writes");
  }

  /**
   * Begins to connect.
   *
   * @param address of the server; its usual port is 6665
   * @param index which of its bases, from 0 on
   */
  public static PlayerConnection open(InetSocketAddress address, int index) {
    PlayerConnection connection = new PlayerConnection(address, index);
    connection.reader.start();
    connection.writer.start();
    return connection;
  }

  private static Thread thread(Runnable work, String name) {
    Thread thread = new Thread(work, name);
    thread.setDaemon(true);
    return thread;
  }

  /** How the base is to move from now on; it does as long as the server lets it. */
  void command(Twist motion) {
    command.clear();
    command.offer(motion);
  }

  Optional<Told> told() {
    return told;
  }

  /** Why the base cannot be used now, one sentence for people. */
  public Optional<String> fault() {
    Optional<Told> last = told;
    if (last.isEmpty()) {
      return Optional.of("The Player server %s %s.".formatted(name(), missing));
    }
    if (System.nanoTime() - last.get().atNanos() > LONGEST_SILENCE.toNanos()) {
      return Optional.of(
          "The Player server %s has not told where the robot is for more than %d s."
              .formatted(name(), LONGEST_SILENCE.toSeconds()));
    }
    return last.filter(Told::stalled).map(stuck -> "The robot's motors are stalled.");
  }

  private String name() {
    return address.getHostString() + ":" + address.getPort();
  }

  private void read() {
    for (int number = 1; !closed; number++) {
      try (Socket open = new Socket()) {
        open.setTcpNoDelay(true);
        open.setSoTimeout(Math.toIntExact(GIVEN_UP_AFTER.toMillis()));
        open.connect(address, Math.toIntExact(CONNECTS_WITHIN.toMillis()));
        readFrom(open, number);
      } catch (IOException e) {
        missing = "does not answer: " + Objects.requireNonNullElse(e.getMessage(), e.toString());
      }
      socket = Optional.empty();
      told = Optional.empty();
      LOG.debug("The Player server {} {}", name(), missing);
      pause();
    }
  }

  private void pause() {
    try {
      closed = end.await(TRIES_AGAIN_AFTER.toMillis(), TimeUnit.MILLISECONDS);
    } catch (InterruptedException e) {
      closed = true;
    }
  }

  private void readFrom(Socket open, int number) throws IOException {
    DataInputStream in = new DataInputStream(new BufferedInputStream(open.getInputStream()));
    DataOutputStream out = new DataOutputStream(open.getOutputStream());
    in.readNBytes(PlayerMessage.BANNER_BYTES);
    PlayerMessage.of(
            PlayerMessage.SERVER, 0, PlayerMessage.REQUEST, USE_DEVICE, this::writeWhichDevice)
        .write(out);
    socket = Optional.of(open);
    while (!closed) {
      PlayerMessage message = PlayerMessage.read(in);
      if (message.is(PlayerMessage.SERVER, PlayerMessage.REFUSED, USE_DEVICE)) {
        throw new IOException("it has no base of number " + index);
      } else if (message.is(PlayerMessage.POSITION_2D, PlayerMessage.DATA, STATE)
          && message.index() == index) {
        told = Optional.of(read(message.body(), number));
      }
    }
  }

  private void writeWhichDevice(DataOutputStream out) throws IOException {
    out.writeInt(0);
    out.writeInt(0);
    out.writeInt(PlayerMessage.POSITION_2D);
    out.writeInt(index);
    out.writeInt(OPEN);
    out.writeInt(0);
    out.writeInt(0);
  }

  private static Told read(DataInputStream body, int number) throws IOException {
    Point2 point = new Point2(body.readDouble(), body.readDouble());
    Stance odometry = new Stance(point, body.readDouble());
    body.readDouble();
    body.readDouble();
    body.readDouble();
    return new Told(odometry, body.readInt() != 0, number, System.nanoTime());
  }

  private void write() {
    while (!closed) {
      try {
        Twist motion = command.take();
        Optional<Socket> open = socket;
        if (open.isPresent()) {
          velocity(motion).write(new DataOutputStream(open.get().getOutputStream()));
        }
      } catch (InterruptedException e) {
        return;
      } catch (IOException e) {
        LOG.debug("A command to the Player server {} is lost", name(), e);
      }
    }
  }

  private PlayerMessage velocity(Twist motion) {
    return PlayerMessage.of(
        PlayerMessage.POSITION_2D,
        index,
        PlayerMessage.COMMAND,
        VELOCITY,
        out -> {
          out.writeDouble(motion.forward());
          out.writeDouble(motion.left());
          out.writeDouble(motion.turn());
          out.writeInt(MOTORS_ON);
        });
  }

  /** The base is not told to stand still: servers see to that when nobody uses it any more. */
  @Override
  public void close() {
    closed = true;
    end.countDown();
    writer.interrupt();
    socket.ifPresent(PlayerConnection::cut);
  }

  private static void cut(Socket open) {
    try {
      open.close();
    } catch (IOException e) {
      LOG.debug("A connection could not be closed", e);
    }
  }
}
