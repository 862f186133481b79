package org.maestro.random;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.maestro.assembly.AgentlessSite;
import org.maestro.coordination.StoryEntry;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.sim.Scene;
import org.maestro.sim.SceneLoader;

/**
 * One random home, its goals pursued while its faults strike, and every claim judged.
 *
 * @param story of all goals, line by line: the same for the same seed
 */
public record RandomRun(RandomHome home, List<Verdict> verdicts, List<String> story) {
  private static final Duration LONGEST = Duration.ofMinutes(20);

  /** Runs without agents. */
  public static RandomRun withoutAgents(RandomHome random) {
    Home home = new HomeLoader().load(random.homeText(), random.name() + ".ttl");
    Scene scene =
        SceneLoader.load(
            random.name(),
            new ByteArrayInputStream(random.sceneText().getBytes(StandardCharsets.UTF_8)),
            home);
    Site judged = new Site(home, scene);
    try (AgentlessSite site = AgentlessSite.start(home, scene, random.seed())) {
      Judge judge = new Judge(judged, () -> Moment.of(site.world(), judged, site.clock().now()));
      for (Fault fault : random.faults()) {
        site.clock()
            .schedule(
                fault.at(),
                "fault",
                () -> {
                  fault.strike(site.world(), site.bus(), site.clock());
                  judge.struck(fault, site.clock().now());
                });
      }
      Map<String, Verdict> verdicts = new LinkedHashMap<>();
      for (String goal : random.goals()) {
        site.pursue(
            goal,
            outcome ->
                verdicts.put(
                    outcome.id(), judge.of(site.parsed(goal), outcome, site.clock().now())));
      }
      site.runUntil(
          () -> {
            judge.timePassed(site.clock().now());
            return verdicts.size() == random.goals().size();
          },
          LONGEST);
      List<Verdict> all = new ArrayList<>(verdicts.values());
      if (all.size() < random.goals().size()) {
        site.coordinator().goals().stream()
            .filter(goal -> !goal.state().isFinal())
            .forEach(goal -> all.add(Judge.withoutEnd(goal + "")));
      }
      return new RandomRun(random, all, lines(site.story()));
    }
  }

  private static List<String> lines(List<StoryEntry> story) {
    return story.stream()
        .map(
            entry ->
                "%s %.3f %s".formatted(entry.goalId(), entry.at().toNanos() / 1e9, entry.text()))
        .toList();
  }

  /** Whether no claim was false. */
  public boolean agrees() {
    return verdicts.stream().allMatch(verdict -> verdict.kind().agrees());
  }

  /** Everything that is needed to understand it, and how to see it again. */
  public String text() {
    return "%s%nfaults %s%n%s%n%s%n%s%nAgain: -Dmaestro.seed=%d"
        .formatted(
            home.homeText(),
            home.faults(),
            home.sceneText(),
            String.join("\n", story),
            verdicts,
            home.seed());
  }
}
