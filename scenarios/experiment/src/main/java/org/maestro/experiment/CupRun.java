package org.maestro.experiment;

import java.time.Duration;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Function;
import org.maestro.experiment.drawing.Figure;
import org.maestro.experiment.running.Ending;
import org.maestro.experiment.running.Trial;
import org.maestro.experiment.running.TrialSite;
import org.maestro.experiment.setting.Physics;
import org.maestro.experiment.setting.Settings;
import org.maestro.hal.Position;
import org.maestro.ontology.home.Home;
import org.maestro.picture.TopView;
import org.maestro.sim.scene.Scene;
import org.maestro.sim.scene.WorldEvent;

/**
 * A broken cup was to be cleaned up.
 *
 * @param deeds what robots did in the simulated world, in order
 * @param success all shards are in the tray, and it was inspected before and vacuumed after
 */
record CupRun(
    int number,
    long seed,
    Ending ending,
    List<Deed> deeds,
    boolean success,
    double seconds,
    List<Figure> pictures)
    implements GoalRun {
  private static final String GOAL = "(cleanedUp Cup)";
  private static final String HOME = "broken-cup";
  private static final List<String> SHARDS = List.of("Shard1", "Shard2");
  private static final Duration PATIENCE = Duration.ofMinutes(10);
  private static final double SCATTER_METRES = 0.1;

  /**
   * An action that a robot has carried out.
   *
   * @param second since the goal was stated
   */
  record Deed(double second, String robot, String what) {}

  static CupRun carryOut(int number, long seed, Settings settings) {
    Home home = Shipped.home(HOME);
    Trial trial = new Trial("cup-" + number, home, scene(home, seed), seed, Physics.of(settings));
    List<Deed> deeds = new CopyOnWriteArrayList<>();
    try (TrialSite site = TrialSite.open(trial)) {
      RovingMember.join(
          site,
          home,
          "scout",
          List.of(
              work(site, deeds, "scout", "inspect", 4, thing -> Map.of("broken", true)),
              work(site, deeds, "scout", "findShard", 2, thing -> seen(site, thing))));
      RovingMember.join(
          site, home, "dusty", List.of(work(site, deeds, "dusty", "vacuum", 8, thing -> Map.of())));
      site.world()
          .listen(
              event -> {
                if (event.kind() == WorldEvent.Kind.PICKED
                    || event.kind() == WorldEvent.Kind.PLACED) {
                  deeds.add(
                      new Deed(
                          event.at().toMillis() / 1e3,
                          event.subject(),
                          event.kind().name().toLowerCase(Locale.ROOT)
                              + " "
                              + event.thing().orElse("")));
                }
              });
      site.run(Duration.ofSeconds(2));
      TopView view = new TopView(home, site.world());
      Ending ending = site.pursue(GOAL, PATIENCE);
      double begun = ending.begun().toMillis() / 1e3;
      return new CupRun(
          number,
          seed,
          ending,
          deeds.stream()
              .map(deed -> new Deed(deed.second() - begun, deed.robot(), deed.what()))
              .toList(),
          isCleanedUp(site, deeds),
          ending.seconds(site.clock().now()),
          number == 1 ? List.of(MoveRun.picture(view, number)) : List.of());
    }
  }

  private static RovingMember.Work work(
      TrialSite site,
      List<Deed> deeds,
      String robot,
      String feature,
      double seconds,
      Function<String, Map<String, Object>> answer) {
    return new RovingMember.Work(
        feature,
        seconds,
        thing -> {
          deeds.add(new Deed(site.clock().now().toMillis() / 1e3, robot, feature + " " + thing));
          return answer.apply(thing);
        });
  }

  /** What is in a hand, or has left the kitchen, does not lie on its floor. */
  private static Map<String, Object> seen(TrialSite site, String thing) {
    if (site.world().holder(thing).isPresent()
        || site.world().zone(thing).filter("kitchen"::equals).isEmpty()) {
      return Map.of("found", false);
    }
    Position place = site.world().position(thing).orElseThrow();
    return Map.of("found", true, "pose", List.of(place.x(), place.y(), place.z()));
  }

  private static boolean isCleanedUp(TrialSite site, List<Deed> deeds) {
    List<String> robots = deeds.stream().map(Deed::robot).distinct().toList();
    return robots.equals(List.of("scout", "rose", "dusty"))
        && deeds.get(deeds.size() - 1).robot().equals("dusty")
        && SHARDS.stream()
            .allMatch(
                shard ->
                    site.world().holder(shard).isEmpty()
                        && site.world().zone(shard).filter("tray"::equals).isPresent());
  }

  private static Scene scene(Home home, long seed) {
    Scene scene = Shipped.scene(HOME, home);
    SplittableRandom random = new SplittableRandom(seed);
    for (String shard : SHARDS) {
      Position place = scene.of(shard).position().orElseThrow();
      scene =
          scene.with(
              shard,
              scene
                  .of(shard)
                  .at(
                      new Position(
                          place.x() + SCATTER_METRES * (2 * random.nextDouble() - 1),
                          place.y() + SCATTER_METRES * (2 * random.nextDouble() - 1),
                          place.z())));
    }
    return scene;
  }

  @Override
  public String goal() {
    return GOAL;
  }

  @Override
  public String failure() {
    if (success) {
      return "";
    }
    return ending.claimed()
        ? "The platform says that it is done, but in the simulated world it is not."
        : ending.explanation();
  }
}
