package org.maestro.experiment;

import java.time.Duration;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import org.maestro.experiment.running.TrialSite;
import org.maestro.hal.Position;
import org.maestro.ontology.home.DescriptionWriter;
import org.maestro.ontology.home.Home;
import org.maestro.rats.member.Execution;
import org.maestro.rats.member.MemberProfile;
import org.maestro.rats.member.Procedure;
import org.maestro.rats.protocol.CostAnswer;

/**
 * A robot that no driver of the simulation knows: it goes to what a call is about, works there for
 * a while, and answers. It goes in a straight line, through whatever stands there (assumed).
 */
final class RovingMember {
  private static final double METRES_PER_SECOND = 0.5;
  private static final double APART_METRES = 0.5;

  /**
   * @param seconds of work at the place
   * @param answer values of the result for the thing that the call is about
   */
  record Work(String feature, double seconds, Function<String, Map<String, Object>> answer) {}

  private RovingMember() {}

  static void join(TrialSite site, Home home, String id, List<Work> works) {
    Map<String, MemberProfile.Feature> features = new LinkedHashMap<>();
    for (Work work : works) {
      features.put(
          work.feature(),
          new MemberProfile.Feature(
              work.feature(),
              Set.of("object"),
              Set.of("base"),
              false,
              Optional.empty(),
              "at-work",
              procedure(site, id, work)));
    }
    site.join(
        new MemberProfile(
            id,
            new DescriptionWriter(home).write(Objects.requireNonNull(home.devices().get(id))),
            Set.of("standby", "at-work"),
            "standby",
            Set.of("standby"),
            features),
        List::of);
  }

  private static Procedure procedure(TrialSite site, String id, Work work) {
    return new Procedure() {
      @Override
      public void start(Execution execution) {
        String thing = thing(execution);
        Position goal = site.world().position(thing).orElseThrow();
        double way = Math.max(0, site.world().distance(id, thing) - APART_METRES);
        long millis = Math.round(1e3 * (way / METRES_PER_SECOND + work.seconds()));
        site.clock()
            .schedule(
                Duration.ofMillis(millis),
                id,
                () -> {
                  if (way > 0) {
                    site.world().moveByHand(id, new Position(goal.x() - APART_METRES, goal.y(), 0));
                  }
                  execution.succeed(work.answer().apply(thing));
                });
      }

      @Override
      public CostAnswer cost(Map<String, Object> parameters) {
        return new CostAnswer(
            Optional.of(work.seconds()), Optional.of(work.seconds()), Optional.empty());
      }
    };
  }

  private static String thing(Execution execution) {
    Object pointer = execution.call().parameters().get("object");
    String iri = pointer instanceof Map<?, ?> map ? String.valueOf(map.get("ref")) : "";
    return iri.substring(iri.indexOf('#') + 1);
  }
}
