package org.maestro.platform.failover;

import static java.nio.charset.StandardCharsets.UTF_8;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicLong;
import org.maestro.deployment.ProcessStart;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The signs of life of who has the duty, in a file beside it: a process that is frozen keeps its
 * lock, and whoever stands by would wait for it for ever. It is ended before anybody takes its
 * place, so that it does nothing when it thaws. For one thread, beside that which beats.
 */
final class LeaderHeartbeat {
  private static final Logger LOG = LoggerFactory.getLogger(LeaderHeartbeat.class);
  private static final String NAME = "duty-beat";
  private static final int LINES = 4;

  /** How often it beats. */
  static final Duration PERIOD = Duration.ofMillis(250);

  /** How long a process is silent that the system has stopped, before it is ended. */
  static final Duration FROZEN_AFTER = Duration.ofSeconds(3);

  /** How long one is silent that might just be short of time. */
  static final Duration HUNG_AFTER = Duration.ofSeconds(15);

  private final Path file;
  private String last = "";
  private Duration silence = Duration.ZERO;
  private boolean isToldOf;

  /** The process that beat last. */
  private record Sign(String machine, long pid, String started) {
    static Sign own() {
      ProcessHandle own = ProcessHandle.current();
      return new Sign(ProcessStart.machineName(), own.pid(), started(own));
    }

    static Sign read(List<String> lines) {
      return new Sign(lines.get(0), Long.parseLong(lines.get(1)), lines.get(2));
    }

    List<String> lines(long number) {
      return List.of(machine, String.valueOf(pid), started, String.valueOf(number));
    }

    /** The process, if it is on this machine and has not ended; another may have its number now. */
    Optional<ProcessHandle> process() {
      return ProcessHandle.of(pid)
          .filter(process -> machine.equals(ProcessStart.machineName()))
          .filter(process -> started(process).equals(started));
    }

    private static String started(ProcessHandle process) {
      return process.info().startInstant().map(Instant::toString).orElse("");
    }
  }

  LeaderHeartbeat(Path directory) {
    this.file = directory.resolve(NAME);
  }

  /** Beats until the process ends; returns what ends it before. */
  Runnable begin() {
    AtomicLong number = new AtomicLong();
    Thread beating =
        new Thread(
            () -> {
              try {
                while (!Thread.currentThread().isInterrupted()) {
                  write(Sign.own().lines(number.incrementAndGet()));
                  Thread.sleep(PERIOD.toMillis());
                }
              } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
              }
            },
            "duty-beat");
    beating.setDaemon(true);
    beating.start();
    return beating::interrupt;
  }

  /** In place: on a full disk a file that was cut first would stay empty, and its writer silent. */
  private void write(List<String> lines) {
    byte[] sign = (String.join("\n", lines) + "\n").getBytes(UTF_8);
    try (FileChannel channel =
        FileChannel.open(file, StandardOpenOption.CREATE, StandardOpenOption.WRITE)) {
      channel.write(ByteBuffer.wrap(sign));
      channel.truncate(sign.length);
    } catch (IOException e) {
      LOG.warn("No sign of life can be written to {}: {}", file, e.getMessage());
    }
  }

  /**
   * Looks after who has the duty, and ends its process when it has been frozen for long. Of another
   * machine that is only told.
   *
   * @param sinceLast since it was last called; a look that comes late counts as one that came in
   *     time, as who slept itself may have slept together with the other
   */
  void look(Duration sinceLast) {
    String now = read();
    if (!now.equals(last) || now.isEmpty()) {
      last = now;
      silence = Duration.ZERO;
      isToldOf = false;
      return;
    }
    silence = silence.plus(sinceLast.compareTo(PERIOD) > 0 ? PERIOD : sinceLast);
    if (silence.compareTo(FROZEN_AFTER) >= 0 && !isToldOf) {
      judge(Sign.read(now.lines().toList()));
    }
  }

  private String read() {
    try {
      String text = Files.readString(file);
      // One that is just being written is looked at the next time.
      return text.lines().count() == LINES ? text : last;
    } catch (IOException e) {
      LOG.debug("Nobody has given signs of life in {} yet", file, e);
      return "";
    }
  }

  private void judge(Sign sign) {
    Optional<ProcessHandle> silent = sign.process();
    if (silent.isEmpty()) {
      isToldOf = true;
      LOG.warn(
          "The platform's process {} on {} has given no sign of life for {} s; end it there, so"
              + " that this one can take over.",
          sign.pid(),
          sign.machine(),
          silence.toSeconds());
    } else if (isStopped(sign.pid()) || silence.compareTo(HUNG_AFTER) >= 0) {
      isToldOf = true;
      LOG.warn(
          "The platform's process {} has given no sign of life for {} s; it is ended, and this one"
              + " takes over.",
          sign.pid(),
          silence.toSeconds());
      silent.get().destroyForcibly();
    }
  }

  /** Whether the system says that it is stopped, as it does on Linux; elsewhere nobody knows. */
  private static boolean isStopped(long pid) {
    try {
      String state = Files.readString(Path.of("/proc", String.valueOf(pid), "stat"));
      // The name before the state is in brackets, and may have blanks and brackets itself.
      String after = state.substring(state.lastIndexOf(')') + 1).strip();
      return after.startsWith("T") || after.startsWith("t");
    } catch (IOException e) {
      LOG.debug("The system does not tell the state of {}", pid, e);
      return false;
    }
  }
}
