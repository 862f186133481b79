package org.maestro.bench.bus;

import java.net.URI;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Random;
import java.util.Set;
import java.util.concurrent.Semaphore;
import org.maestro.bench.BenchReport;
import org.maestro.bench.LargeHome;
import org.maestro.bench.Quantile;
import org.maestro.ontology.home.DescriptionWriter;
import org.maestro.ontology.home.Device;
import org.maestro.ontology.home.Home;
import org.maestro.rats.link.BusLink;
import org.maestro.rats.link.RatsLink;
import org.maestro.rats.protocol.CostAnswer;
import org.maestro.rats.protocol.MemberStatus;
import org.maestro.rats.time.Clock;
import org.maestro.rats.transport.PahoTransport;
import org.maestro.sim.SimulatedHome;

/**
 * The response time of a simulated robot that is asked what its ways cost, from the question to the
 * answer over the bus: it searches for a way to each place that is asked for. The baseline is what
 * is demanded.
 */
public final class PricesAsked implements AutoCloseable {
  private static final String SITE = "bench-prices";
  private static final String FEATURE = "move";
  private static final double DEMANDED_MILLIS = 50;
  private static final double NANOS_IN_MILLI = 1e6;
  private static final int ASKED_FIRST = 100;
  private static final int ASKED = 500;
  private static final int PLACES = 4;

  private static final LargeHome LARGE = new LargeHome(18, 1, 2);

  private final Home home = LARGE.home();
  private final List<String> zones =
      home.individuals().values().stream()
          .filter(individual -> individual.classes().contains("Zone"))
          .map(individual -> individual.iri())
          .toList();
  private final String robot =
      home.devices().values().stream()
          .filter(device -> offers(device, FEATURE))
          .map(Device::id)
          .findFirst()
          .orElseThrow();
  private final Random chance = new Random(1);
  private final SimulatedHome simulated;
  private final RatsLink link;

  PricesAsked(URI broker, Clock clock) {
    simulated =
        SimulatedHome.start(
            new SimulatedHome.Setup(
                    home,
                    LARGE.scene(home),
                    clock,
                    1,
                    id -> new PahoTransport(broker, id),
                    SITE,
                    new DescriptionWriter(home)::write)
                .only(Set.of(robot)));
    link = BusLink.connect("asker", SITE, new PahoTransport(broker, "asker"), clock);
    Semaphore ready = new Semaphore(0);
    link.watch(
        robot,
        member -> {
          if (member.phase() == MemberStatus.Phase.READY) {
            ready.release();
          }
        });
    BusBench.await(ready, 1);
  }

  private static boolean offers(Device device, String feature) {
    return device.features().stream().anyMatch(type -> type.name().equals(feature));
  }

  List<BenchReport.Row> rows() {
    ask(ASKED_FIRST);
    List<Long> nanos = ask(ASKED);
    return List.of(row("p50", nanos, 0.5), row("p99", nanos, 0.99));
  }

  private static BenchReport.Row row(String name, List<Long> nanos, double share) {
    return new BenchReport.Row(
        "a robot's prices for ways to %d places, %s (demanded: %.0f)"
            .formatted(PLACES, name, DEMANDED_MILLIS),
        Quantile.of(nanos, share) / NANOS_IN_MILLI,
        "ms",
        OptionalDouble.of(DEMANDED_MILLIS));
  }

  private List<Long> ask(int times) {
    List<Long> nanos = new ArrayList<>();
    for (int time = 0; time < times; time++) {
      List<Map<String, Object>> sets = new ArrayList<>();
      for (int place = 0; place < PLACES; place++) {
        sets.add(Map.of("to", Map.of("ref", zones.get(chance.nextInt(zones.size())))));
      }
      Semaphore answered = new Semaphore(0);
      long before = System.nanoTime();
      link.cost(robot, FEATURE, sets, answers -> told(answers, answered));
      BusBench.await(answered, 1);
      nanos.add(System.nanoTime() - before);
    }
    return nanos;
  }

  private static void told(List<CostAnswer> answers, Semaphore answered) {
    Optional<CostAnswer> without =
        answers.stream().filter(answer -> answer.cost().isEmpty()).findFirst();
    if (without.isPresent()) {
      throw new IllegalStateException("A price is missing: " + without.get());
    }
    answered.release();
  }

  @Override
  public void close() {
    link.close();
    simulated.close();
  }
}
