package org.maestro.chaos;

import static java.nio.charset.StandardCharsets.UTF_8;

import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.TreeMap;
import java.util.function.Function;
import org.maestro.random.Fault;
import org.maestro.rats.protocol.MalformedMessageException;
import org.maestro.rats.protocol.Result;
import org.maestro.rats.protocol.WireFormat;
import org.maestro.rats.time.Clock;
import org.maestro.rats.transport.Disturbance;
import org.maestro.rats.transport.Disturbance.Copy;
import org.maestro.rats.transport.Publication;

/**
 * Draws what goes wrong on the bus while goals are pursued: the broker killed, the main process
 * frozen, results late, doubled, lost or unreadable, states late, what others say in the names of
 * members, and rubbish.
 */
final class ChaosFaults {
  private static final int LATEST_MILLIS = 30_000;
  private static final String CONTROLLER = "maestro";

  private final Random random;
  private final boolean agents;

  private Optional<Disturbances> disturbances = Optional.empty();

  /**
   * @param agents whether the platform has any: each has a thread of its own, which no clock stops
   */
  ChaosFaults(long seed, boolean agents) {
    this.random = new Random(~seed * 0x9E3779B97F4A7C15L);
    this.agents = agents;
  }

  List<Fault> draw() {
    List<Fault> faults = new ArrayList<>();
    int count = 1 + random.nextInt(5);
    for (int number = 0; number < count; number++) {
      Duration at = soon();
      faults.add(
          switch (random.nextInt(10)) {
            case 0 -> new Fault.BrokerDown(at, millis(200, 15_000));
            case 1, 2 -> frozen(at, millis(1_000, 30_000));
            case 3 -> late(at, "/result/", "results late", millis(500, 8_000));
            case 4 -> late(at, "/state", "states late", millis(500, 8_000));
            case 5 -> doubled(at, millis(0, 5_000));
            case 6 -> lost(at, 0.2 + random.nextDouble() / 2);
            case 7 -> forged(at);
            case 8 -> useless(at, random.nextInt(3));
            default -> rubbish(at);
          });
    }
    faults.sort(Comparator.comparing(Fault::at));
    return faults;
  }

  /** Rather early, as most goals are over after some seconds. */
  private Duration soon() {
    double share = random.nextDouble();
    return Duration.ofMillis((long) (LATEST_MILLIS * share * share));
  }

  private Duration millis(int least, int most) {
    return Duration.ofMillis(least + random.nextInt(most - least));
  }

  private Fault frozen(Duration at, Duration lasts) {
    return agents ? silenced(at, lasts) : new Fault.Frozen(at, lasts);
  }

  /** Nothing goes in or out; then all that came meanwhile is heard at once. */
  private Fault silenced(Duration at, Duration lasts) {
    return disturbed(
        at,
        "main process frozen",
        lasts,
        Duration.ZERO,
        left ->
            new Disturbance() {
              @Override
              public List<Copy> published(String client, Publication publication) {
                return List.of(
                    new Copy(publication, client.equals(CONTROLLER) ? left.get() : Duration.ZERO));
              }

              @Override
              public Duration heardLater(String client) {
                return client.equals(CONTROLLER) ? left.get() : Duration.ZERO;
              }
            });
  }

  /** All of a kind, so that each publisher's own order stays. */
  private Fault late(Duration at, String kind, String name, Duration later) {
    return disturbed(
        at,
        name + " by " + later.toMillis() + " ms",
        millis(5_000, 30_000),
        later,
        left -> onlyOf(kind, publication -> List.of(new Copy(publication, later))));
  }

  private Fault doubled(Duration at, Duration later) {
    return disturbed(
        at,
        "results and calls twice, after " + later.toMillis() + " ms",
        millis(5_000, 30_000),
        later,
        left ->
            new Disturbance() {
              @Override
              public List<Copy> published(String client, Publication publication) {
                return publication.retained()
                    ? List.of(new Copy(publication, Duration.ZERO))
                    : List.of(new Copy(publication, Duration.ZERO), new Copy(publication, later));
              }
            });
  }

  private Fault lost(Duration at, double share) {
    Random chance = new Random(random.nextLong());
    return disturbed(
        at,
        "results lost: %.2f".formatted(share),
        millis(2_000, 15_000),
        Duration.ZERO,
        left ->
            onlyOf(
                "/result/",
                publication ->
                    chance.nextDouble() < share
                        ? List.of()
                        : List.of(new Copy(publication, Duration.ZERO))));
  }

  /** Results without their values, with values of another kind, or that nobody can read. */
  private Fault useless(Duration at, int kind) {
    return disturbed(
        at,
        List.of("results without values", "values of another kind", "results unreadable").get(kind),
        millis(1_000, 10_000),
        Duration.ZERO,
        left ->
            onlyOf(
                "/result/",
                publication -> List.of(new Copy(useless(publication, kind), Duration.ZERO))));
  }

  /** What a stranger says in a member's name may be no result at all, and stays what it is. */
  private static Publication useless(Publication publication, int kind) {
    try {
      return madeUseless(publication, kind);
    } catch (MalformedMessageException rubbish) {
      return publication;
    }
  }

  private static Publication madeUseless(Publication publication, int kind) {
    WireFormat wire = new WireFormat();
    byte[] payload = publication.payload();
    if (kind == 2) {
      payload = Arrays.copyOf(payload, payload.length / 2);
    } else {
      Result result = wire.decodeResult(payload);
      Map<String, Object> values = new TreeMap<>();
      if (kind == 1) {
        result.values().keySet().forEach(name -> values.put(name, List.of("neither", true)));
      }
      payload =
          wire.encode(
              new Result(
                  result.id(),
                  result.from(),
                  result.outcome(),
                  result.state(),
                  values,
                  result.error()));
    }
    return new Publication(
        publication.topic(),
        payload,
        publication.quality(),
        publication.retained(),
        publication.expiry());
  }

  private static Disturbance onlyOf(String kind, Function<Publication, List<Copy>> fate) {
    return new Disturbance() {
      @Override
      public List<Copy> published(String client, Publication publication) {
        return publication.topic().contains(kind)
            ? fate.apply(publication)
            : List.of(new Copy(publication, Duration.ZERO));
      }
    };
  }

  /** The time that is left of a disturbance. */
  private interface Left {
    Duration get();
  }

  private Fault disturbed(
      Duration at,
      String name,
      Duration lasts,
      Duration aftermath,
      Function<Left, Disturbance> made) {
    return new Fault.Disturbed(
        at,
        name,
        lasts.plus(aftermath),
        (bus, clock) -> {
          Duration end = clock.now().plus(lasts);
          of(clock)
              .add(
                  bus,
                  made.apply(
                      () -> {
                        Duration left = end.minus(clock.now());
                        return left.isNegative() ? Duration.ZERO : left;
                      }),
                  lasts);
        });
  }

  /** Those of the one run that these faults are for. */
  private Disturbances of(Clock clock) {
    Disturbances all = disturbances.orElseGet(() -> new Disturbances(clock));
    disturbances = Optional.of(all);
    return all;
  }

  /** In the name of one of those who are there. */
  private Fault forged(Duration at) {
    String phase = List.of("ready", "init", "lost", "").get(random.nextInt(4));
    String boot = List.of("0", "zzzzzzzzzzzz", "own").get(random.nextInt(3));
    int which = random.nextInt(1_000);
    return new Fault.Disturbed(
        at,
        "forged status '" + phase + "' of boot " + boot,
        Duration.ofSeconds(5),
        (bus, clock) -> Stranger.on(bus, clock).forges(which, phase, boot));
  }

  private Fault rubbish(Duration at) {
    Random chance = new Random(random.nextLong());
    return new Fault.Disturbed(
        at,
        "rubbish",
        Duration.ofSeconds(5),
        (bus, clock) -> Stranger.on(bus, clock).litters(chance));
  }

  static byte[] text(String text) {
    return text.getBytes(UTF_8);
  }
}
