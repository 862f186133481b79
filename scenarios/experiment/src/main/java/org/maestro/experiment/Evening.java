package org.maestro.experiment;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.maestro.experiment.drawing.Figure;
import org.maestro.experiment.running.Ending;
import org.maestro.experiment.running.Trial;
import org.maestro.experiment.running.TrialSite;
import org.maestro.hal.Area;
import org.maestro.hal.Drivers;
import org.maestro.hal.Switch;
import org.maestro.ontology.home.Device;
import org.maestro.picture.TopView;
import org.maestro.sim.parameters.PhysicalParameters;
import org.maestro.sim.world.FloorMap;
import org.maestro.sl.Term;

/**
 * The evening as it passes in one of the homes: goals are stated when it is their time, judged by
 * the world the moment they end, and light and power are read once a second. For one thread.
 */
final class Evening {
  private static final Duration PATIENCE = Duration.ofMinutes(10);
  private static final Duration BETWEEN_READINGS = Duration.ofSeconds(1);
  private static final double SECONDS_PER_HOUR = 3600;
  private static final double MILLIS = 1e3;

  private final TrialSite site;
  private final Comparison.SetUp setUp;
  private final double batteryWattHours;
  private final Duration begun;
  private final List<Stated> stated = new ArrayList<>();
  private final Map<String, Double> luxSeconds = new TreeMap<>();
  private final Map<String, Double> charges = new TreeMap<>();
  private double wattHours;
  private Duration read;

  /** A goal under way, and what came of it once it is over. */
  private static final class Stated {
    private final Wish wish;
    private final TrialSite.Underway goal;
    private final Duration latest;
    private Optional<EveningRun.Wanted> over = Optional.empty();

    Stated(Wish wish, TrialSite.Underway goal, Duration latest) {
      this.wish = wish;
      this.goal = goal;
      this.latest = latest;
    }
  }

  private Evening(TrialSite site, Comparison.SetUp setUp, PhysicalParameters physics) {
    this.site = site;
    this.setUp = setUp;
    this.batteryWattHours = physics.battery().wattHours();
    this.begun = site.clock().now();
    this.read = begun;
  }

  /**
   * @param pictured whether a picture is taken of its end
   */
  static EveningRun pass(
      int number,
      long seed,
      Comparison.SetUp setUp,
      List<Wish> wishes,
      PhysicalParameters physics,
      boolean pictured) {
    Trial trial = new Trial("setups-" + number, setUp.home(), setUp.scene(), seed, physics);
    try (TrialSite site = TrialSite.open(trial)) {
      TopView view = new TopView(setUp.home(), site.world());
      Evening evening = new Evening(site, setUp, physics);
      evening.pass(wishes);
      return evening.run(
          number, seed, pictured ? List.of(MoveRun.picture(view, number)) : List.of());
    }
  }

  private void pass(List<Wish> wishes) {
    int next = 0;
    readMeters();
    while (next < wishes.size() || isAnyOpen()) {
      while (next < wishes.size() && isDue(wishes.get(next))) {
        Wish wish = wishes.get(next++);
        stated.add(new Stated(wish, site.begin(wish.goal()), site.clock().now().plus(PATIENCE)));
      }
      Duration until = next < wishes.size() ? untilDue(wishes.get(next)) : BETWEEN_READINGS;
      site.runUntil(() -> stated.stream().anyMatch(this::isToBeJudged), until);
      stated.stream().filter(this::isToBeJudged).forEach(this::judge);
      readMeters();
    }
  }

  private boolean isAnyOpen() {
    return stated.stream().anyMatch(one -> one.over.isEmpty());
  }

  private boolean isDue(Wish wish) {
    return wish.at()
        .map(at -> begun.plus(at).compareTo(site.clock().now()) <= 0)
        .orElseGet(() -> !isAnyOpen());
  }

  private Duration untilDue(Wish wish) {
    return wish.at()
        .map(at -> begun.plus(at).minus(site.clock().now()))
        .filter(left -> left.compareTo(BETWEEN_READINGS) < 0)
        .orElse(BETWEEN_READINGS);
  }

  private boolean isToBeJudged(Stated one) {
    return one.over.isEmpty()
        && (one.goal.hasEnded() || one.latest.compareTo(site.clock().now()) <= 0);
  }

  private void judge(Stated one) {
    Ending ending = one.goal.ending();
    Map<String, Term> binding = ending.report().map(report -> report.binding()).orElseGet(Map::of);
    one.over =
        Optional.of(
            new EveningRun.Wanted(
                one.wish,
                ending,
                site.truth(one.wish.goal(), binding),
                ending.seconds(site.clock().now())));
  }

  private void readMeters() {
    double seconds = site.clock().now().minus(read).toMillis() / MILLIS;
    read = site.clock().now();
    for (Area area : site.world().building().map().areas()) {
      luxSeconds.merge(area.name(), seconds * site.world().lux(area.name()), Double::sum);
    }
    for (String id : site.simulated().devices()) {
      wattHours += watts(id) * seconds / SECONDS_PER_HOUR + fromBattery(id);
    }
  }

  /**
   * Of what states how much it draws: a lamp as far as it is turned up, an appliance that is on.
   */
  private double watts(String id) {
    Device device = setUp.home().devices().get(id);
    double full = device == null ? 0 : FloorMap.number(device.individual(), "power").orElse(0);
    Drivers drivers = site.simulated().drivers(id);
    boolean isOn = drivers.find(Switch.class).filter(Switch::isOn).isPresent();
    return site.world().lighting().hasLamp(id)
        ? full * site.world().lampLevel(id)
        : isOn ? full : 0;
  }

  /** Since it was read last; of one that is charged meanwhile, nothing. */
  private double fromBattery(String id) {
    double now = site.world().charge(id);
    double before = charges.getOrDefault(id, now);
    charges.put(id, now);
    return Math.max(0, before - now) * batteryWattHours;
  }

  private EveningRun run(int number, long seed, List<Figure> pictures) {
    double seconds = site.clock().now().minus(begun).toMillis() / MILLIS;
    Map<String, Double> lux = new TreeMap<>();
    luxSeconds.forEach((zone, sum) -> lux.put(zone, seconds == 0 ? Double.NaN : sum / seconds));
    return new EveningRun(
        number,
        seed,
        setUp.name(),
        stated.stream().map(one -> one.over.orElseThrow()).toList(),
        seconds,
        wattHours,
        lux,
        pictures);
  }
}
