package org.maestro.launch;

import java.io.PrintWriter;
import java.time.Duration;
import java.util.Optional;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Consumer;
import org.maestro.rats.stream.RecordingWriter;
import org.maestro.rats.stream.StreamFigures;
import org.maestro.rats.stream.StreamReceiver;
import org.maestro.text.VisibleText;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * A stream on its way from the clock's thread, which tells of frames, to the command's own, which
 * waits for the disk. Between them two hundred frames have room; more are given up, and told at the
 * end.
 */
final class StreamReception implements StreamReceiver.Listener {
  private static final Logger LOG = LoggerFactory.getLogger(StreamReception.class);
  private static final int MOST_WAITING = 200;
  private static final long LOOKS_EVERY_MILLIS = 100;
  private static final int BYTES_PER_KILOBYTE = 1000;
  private static final Duration BEGINS_WITHIN = Duration.ofSeconds(20);
  private static final Duration LEAVES_WITHIN = Duration.ofSeconds(5);
  private static final double NANOS = 1e9;
  private static final double NANOS_PER_MILLI = 1e6;

  /** Clocks of one machine, read on both sides, do not differ by more. */
  private static final Duration CLOCKS_AGREE = Duration.ofMillis(-5);

  private final StreamReceiver.Wanted wanted;
  private final Optional<RecordingWriter> recording;
  private final Consumer<StreamReceiver.Received> also;
  private final PrintWriter out;
  private final StreamFigures figures = new StreamFigures();
  private final BlockingQueue<StreamReceiver.Received> frames =
      new ArrayBlockingQueue<>(MOST_WAITING);
  private final AtomicLong givenUp = new AtomicLong();
  private final CountDownLatch begunOrOver = new CountDownLatch(1);
  private final CountDownLatch told = new CountDownLatch(1);
  private volatile boolean isOver;
  private volatile Optional<String> reason = Optional.empty();

  /**
   * @param also is told each frame on the clock's thread
   */
  StreamReception(
      StreamReceiver.Wanted wanted,
      Optional<RecordingWriter> recording,
      Consumer<StreamReceiver.Received> also,
      PrintWriter out) {
    this.wanted = wanted;
    this.recording = recording;
    this.also = also;
    this.out = out;
  }

  @Override
  public void began() {
    begunOrOver.countDown();
  }

  @Override
  public void received(StreamReceiver.Received received) {
    figures.add(received);
    also.accept(received);
    if (recording.isPresent() && !frames.offer(received)) {
      givenUp.incrementAndGet();
    }
  }

  @Override
  public void ended(Optional<String> why) {
    reason = why;
    isOver = true;
    begunOrOver.countDown();
  }

  /**
   * Records until the time is over, the stream has ended, or the process is told to end, and tells
   * the figures.
   *
   * @throws CommandException when nothing streams
   */
  void take(StreamReceiver receiver, Optional<Duration> time) {
    Thread command = Thread.currentThread();
    Thread stopping = new Thread(() -> stop(command), "shutdown");
    Runtime.getRuntime().addShutdownHook(stopping);
    long begunAt = System.nanoTime();
    try {
      awaitBeginning();
      out.printf("%s streams (%s). Stop with Ctrl-C.%n", wanted.member(), wanted.feature());
      out.flush();
      begunAt = System.nanoTime();
      record(begunAt + time.map(Duration::toNanos).orElse(Long.MAX_VALUE / 2));
    } catch (InterruptedException stopped) {
      // That is how it is usually ended: what has arrived is told.
    } finally {
      leave(receiver);
    }
    for (var left = Optional.ofNullable(frames.poll());
        left.isPresent();
        left = Optional.ofNullable(frames.poll())) {
      write(left.get());
    }
    tell((System.nanoTime() - begunAt) / NANOS);
    told.countDown();
    forget(stopping);
  }

  private void awaitBeginning() throws InterruptedException {
    if (!begunOrOver.await(BEGINS_WITHIN.toMillis(), TimeUnit.MILLISECONDS)) {
      throw CommandException.outside(
          "There is no %s on the bus that is ready; ./maestro agents tells who is."
              .formatted(wanted.member()));
    }
    if (isOver) {
      throw CommandException.outside(
          "%s does not stream (%s): %s"
              .formatted(
                  wanted.member(),
                  wanted.feature(),
                  VisibleText.line(reason.orElse("it has ended already"))));
    }
  }

  private void record(long until) throws InterruptedException {
    while (System.nanoTime() - until < 0 && !(isOver && frames.isEmpty())) {
      Optional.ofNullable(frames.poll(LOOKS_EVERY_MILLIS, TimeUnit.MILLISECONDS))
          .ifPresent(this::write);
    }
  }

  private void write(StreamReceiver.Received one) {
    recording.ifPresent(
        writer -> writer.add(one.frame(), one.frame().capturedAt().plus(one.delay())));
  }

  private static void leave(StreamReceiver receiver) {
    receiver.close();
    try {
      receiver.left().get(LEAVES_WITHIN.toMillis(), TimeUnit.MILLISECONDS);
    } catch (ExecutionException | TimeoutException late) {
      LOG.debug("The site was not left in time: {}", late.toString());
    } catch (InterruptedException interrupted) {
      Thread.currentThread().interrupt();
    }
  }

  private void tell(double seconds) {
    out.printf(
        "%d frames (%d kB) in %.1f s; %d did not arrive, in %d gaps%s.%n",
        figures.frames(),
        figures.bytes() / BYTES_PER_KILOBYTE,
        seconds,
        figures.missed(),
        figures.gaps(),
        givenUp.get() > 0
            ? ", and %d arrived faster than they could be recorded".formatted(givenUp.get())
            : "");
    figures.delay(0).ifPresent(this::tellDelays);
    reason.ifPresent(
        why -> out.printf("%s ended the stream: %s%n", wanted.member(), VisibleText.line(why)));
    out.flush();
  }

  private void tellDelays(Duration shortest) {
    if (shortest.compareTo(CLOCKS_AGREE) < 0) {
      out.printf(
          "Delays cannot be told: the clock of %s is %.0f ms ahead or more, or runs at another speed.%n",
          wanted.member(), -millis(shortest));
      return;
    }
    out.printf(
        "Delay from capture to arrival: p50 %.1f ms, p99 %.1f ms, at most %.1f ms.%n",
        delay(0.5), delay(0.99), delay(1));
  }

  private double delay(double share) {
    return millis(figures.delay(share).orElseThrow());
  }

  private static double millis(Duration duration) {
    return duration.toNanos() / NANOS_PER_MILLI;
  }

  /** The end of the process waits until what has arrived is told. */
  private void stop(Thread command) {
    command.interrupt();
    try {
      if (!told.await(2 * LEAVES_WITHIN.toMillis(), TimeUnit.MILLISECONDS)) {
        LOG.debug("The process ends before the figures are told");
      }
    } catch (InterruptedException interrupted) {
      Thread.currentThread().interrupt();
    }
  }

  /** Nothing where the process is ending already. */
  private static void forget(Thread stopping) {
    try {
      Runtime.getRuntime().removeShutdownHook(stopping);
    } catch (IllegalStateException ending) {
      LOG.debug("The process ends: {}", ending.toString());
    }
  }
}
