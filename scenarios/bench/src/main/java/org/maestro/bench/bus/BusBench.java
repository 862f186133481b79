package org.maestro.bench.bus;

import static java.nio.charset.StandardCharsets.US_ASCII;

import java.lang.management.CompilationMXBean;
import java.lang.management.ManagementFactory;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.concurrent.Semaphore;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import org.maestro.bench.BenchReport;
import org.maestro.bench.Quantile;
import org.maestro.rats.broker.EmbeddedBroker;
import org.maestro.rats.member.RatsMember;
import org.maestro.rats.protocol.Call;
import org.maestro.rats.protocol.WireFormat;
import org.maestro.rats.time.PacedClock;
import org.maestro.rats.transport.InProcessBus;

/**
 * The bus against the bare MQTT client: same broker, same bytes of a call, same run, in turns. What
 * is answered at once has no sign of life before its result: both send two messages for a call.
 * Measured is what a bus does that has run for a while: after hundreds of calls the compilers of
 * the virtual machine still take more of the cores than the calls do, so it is warmed up until they
 * are nearly done. How it is at first is told too.
 */
public final class BusBench {
  private static final byte[] PADDING = "x".repeat(100).getBytes(US_ASCII);
  private static final int WARM_UP_ROUND = 500;
  private static final int MOST_WARM_UP_ROUNDS = 40;

  /** Of the wall time; both cores of a small machine would have 2. */
  private static final double LITTLE_COMPILING = 0.05;

  private static final int ROUNDS = 10;
  private static final int CALLS_A_ROUND = 200;
  private static final int MEMBERS = 50;
  private static final int UNDER_WAY = 16;
  private static final int CALLS_OF_MANY = 1_000;
  private static final int IDLE = 1_000;
  private static final long LONGEST_SECONDS = 60;
  private static final double NANOS_IN_MILLI = 1e6;
  private static final CompilationMXBean COMPILERS = ManagementFactory.getCompilationMXBean();

  private final Consumer<String> progress;

  public BusBench(Consumer<String> progress) {
    this.progress = progress;
  }

  public BenchReport run() {
    List<BenchReport.Row> rows = new ArrayList<>();
    byte[] payload = payload();
    // First, while nothing else has lived in this heap.
    progress.accept(IDLE + " idle members: heap");
    BenchReport.Row idle = heap();
    try (EmbeddedBroker broker = EmbeddedBroker.start();
        PacedClock clock = new PacedClock(1)) {
      progress.accept("one member: from call to result");
      try (BusParty members = BusParty.ofMembers(broker.uri(), 1, PADDING, clock);
          BusParty bare = BusParty.ofBareClients(broker.uri(), 1, payload)) {
        rows.addAll(latency(members, bare));
      }
      progress.accept(MEMBERS + " members on one bus: calls per second");
      try (BusParty members = BusParty.ofMembers(broker.uri(), MEMBERS, PADDING, clock);
          BusParty bare = BusParty.ofBareClients(broker.uri(), MEMBERS, payload)) {
        rows.add(throughput(members, bare));
      }
      progress.accept("a robot: from the question for prices to its answer");
      try (PricesAsked prices = new PricesAsked(broker.uri(), clock)) {
        rows.addAll(prices.rows());
      }
    }
    rows.add(idle);
    return new BenchReport("bus", BenchReport.thisMachine(), rows);
  }

  /** As many bytes as a call of the same padding. */
  private static byte[] payload() {
    return new WireFormat()
        .encode(
            new Call(
                "bench-12345678-1000",
                Optional.of("member-0"),
                Optional.of("dn0zcqu0fcw5"),
                "echo",
                Map.of("padding", new String(PADDING, US_ASCII)),
                Duration.ofSeconds(30),
                "bench",
                Optional.empty()));
  }

  private static List<BenchReport.Row> latency(BusParty members, BusParty bare) {
    List<Long> oursAtFirst = sequential(members, WARM_UP_ROUND);
    List<Long> theirsAtFirst = sequential(bare, WARM_UP_ROUND);
    warmUp(() -> sequential(members, WARM_UP_ROUND), () -> sequential(bare, WARM_UP_ROUND));
    List<Long> ours = new ArrayList<>();
    List<Long> theirs = new ArrayList<>();
    for (int round = 0; round < ROUNDS; round++) {
      ours.addAll(sequential(members, CALLS_A_ROUND));
      theirs.addAll(sequential(bare, CALLS_A_ROUND));
    }
    return List.of(
        row("call to result, p50", ours, theirs, 0.5),
        row("call to result, p99", ours, theirs, 0.99),
        row("call to result, p50 of the first " + WARM_UP_ROUND, oursAtFirst, theirsAtFirst, 0.5));
  }

  /** In turns, until the compilers have little to do for ours; no more than some rounds. */
  private static void warmUp(Runnable ours, Runnable theirs) {
    double share = 1;
    for (int round = 0; round < MOST_WARM_UP_ROUNDS && share > LITTLE_COMPILING; round++) {
      theirs.run();
      long begun = System.nanoTime();
      long compiledBefore = COMPILERS.getTotalCompilationTime();
      ours.run();
      double millis = (System.nanoTime() - begun) / NANOS_IN_MILLI;
      share = (COMPILERS.getTotalCompilationTime() - compiledBefore) / millis;
    }
  }

  private static BenchReport.Row row(
      String name, List<Long> ours, List<Long> theirs, double share) {
    return new BenchReport.Row(
        name,
        Quantile.of(ours, share) / NANOS_IN_MILLI,
        "ms",
        OptionalDouble.of(Quantile.of(theirs, share) / NANOS_IN_MILLI));
  }

  private static List<Long> sequential(BusParty party, int calls) {
    List<Long> nanos = new ArrayList<>();
    Semaphore answered = new Semaphore(0);
    for (int call = 0; call < calls; call++) {
      long before = System.nanoTime();
      party.call(0, answered::release);
      await(answered, 1);
      nanos.add(System.nanoTime() - before);
    }
    return nanos;
  }

  private static BenchReport.Row throughput(BusParty members, BusParty bare) {
    warmUp(() -> concurrent(members, WARM_UP_ROUND), () -> concurrent(bare, WARM_UP_ROUND));
    double[] ours = new double[3];
    double[] theirs = new double[3];
    for (int round = 0; round < ours.length; round++) {
      ours[round] = concurrent(members, CALLS_OF_MANY);
      theirs[round] = concurrent(bare, CALLS_OF_MANY);
    }
    Arrays.sort(ours);
    Arrays.sort(theirs);
    return new BenchReport.Row(
        MEMBERS + " members on one bus, " + UNDER_WAY + " calls under way",
        ours[1],
        "calls/s",
        OptionalDouble.of(theirs[1]));
  }

  private static double concurrent(BusParty party, int calls) {
    Semaphore free = new Semaphore(UNDER_WAY);
    long before = System.nanoTime();
    for (int call = 0; call < calls; call++) {
      await(free, 1);
      party.call(call % MEMBERS, free::release);
    }
    await(free, UNDER_WAY);
    return calls * 1e9 / (System.nanoTime() - before);
  }

  static void await(Semaphore semaphore, int permits) {
    try {
      if (!semaphore.tryAcquire(permits, LONGEST_SECONDS, TimeUnit.SECONDS)) {
        throw new IllegalStateException("No answer came within " + LONGEST_SECONDS + " s");
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IllegalStateException("The benchmark was interrupted", e);
    }
  }

  /** Without their clients: on a bus within the process. */
  private static BenchReport.Row heap() {
    try (PacedClock clock = new PacedClock(1)) {
      InProcessBus bus = new InProcessBus(clock);
      List<RatsMember> members = new ArrayList<>();
      BusParty.start("first", bus.client("first"), clock);
      settle(clock);
      long before = used();
      for (int number = 0; number < IDLE; number++) {
        String id = "idle-" + number;
        members.add(BusParty.start(id, bus.client(id), clock));
      }
      settle(clock);
      long after = used();
      double each = (after - before) / 1_024.0 / members.size();
      return BenchReport.Row.of(IDLE + " idle members, heap of each", each, "KiB");
    }
  }

  /** Until everything that was sent before has arrived. */
  private static void settle(PacedClock clock) {
    Semaphore passed = new Semaphore(0);
    clock.schedule(Duration.ofSeconds(3), "bench", passed::release);
    await(passed, 1);
  }

  private static long used() {
    Runtime runtime = Runtime.getRuntime();
    long least = Long.MAX_VALUE;
    for (int round = 0; round < 5; round++) {
      System.gc();
      least = Math.min(least, runtime.totalMemory() - runtime.freeMemory());
    }
    return least;
  }
}
