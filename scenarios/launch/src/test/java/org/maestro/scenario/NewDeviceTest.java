package org.maestro.scenario;

import static org.maestro.junit.MaestroAssertions.assertThat;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.maestro.hal.Position;
import org.maestro.junit.GoalOutcome;
import org.maestro.junit.MaestroTest;
import org.maestro.junit.Stage;
import org.maestro.rats.member.Execution;
import org.maestro.rats.member.MemberProfile;
import org.maestro.rats.member.Procedure;
import org.maestro.rats.member.RatsMember;
import org.maestro.rats.protocol.CostAnswer;

/**
 * Kinds of devices that no vocabulary and no code has ever named join the bus with a description,
 * and the next plan uses them.
 */
@MaestroTest(home = "bob", scene = "bob-dark")
class NewDeviceTest {

  private static final String WISH = "(nextTo Cup Bob)";

  private static final String GLIMMER =
      """
      {"@context": "https://w3id.org/maestro/context.jsonld",
       "id": "https://example.org/wonders#glimmer-1",
       "type": ["maestro:Device", "https://example.org/wonders#Glimmer"],
       "label": "the glimmer", "container": "wonders",
       "pose": "5 1 2.5",
       "https://example.org/wonders#shimmering": 80,
       "offers": {"id": "https://example.org/wonders#shimmer", "type": "maestro:Action",
         "sentence": "{self} shimmers in {zone}",
         "binds": {"name": "zone", "types": ["maestro:Zone"]},
         "precondition": "(inside ?self ?zone)",
         "effect": "(increase (illuminance ?zone) 80)",
         "cost": "0.2", "seconds": "0.2"}}
      """;

  static final String BAND =
      """
      {"@context": "https://w3id.org/maestro/context.jsonld",
       "id": "https://example.org/wonders#band-1",
       "type": ["maestro:Device", "https://example.org/wonders#CarryingBand"],
       "label": "the band",
       "offers": {"id": "https://example.org/wonders#waft", "type": "maestro:Task",
         "sentence": "{self} wafts {object} to {target}",
         "input": [
           {"name": "object", "types": ["https://w3id.org/maestro/domain#Item"]},
           {"name": "target", "types": ["https://w3id.org/maestro/domain#Person"]}],
         "binds": [
           {"name": "from", "types": ["maestro:Zone"]},
           {"name": "to", "types": ["maestro:Zone"]}],
         "precondition": "(and (in ?object ?from) (in ?target ?to))",
         "effect": "(and (in ?object ?to) (nextTo ?object ?target))",
         "occupies": ["belt"],
         "cost": {"id": "maestro:asked"}, "costAtLeast": "0.5", "seconds": "2"}}
      """;

  @Test
  void anotherLightIsCheaperThanTheLamps(Stage stage) {
    joins(stage, "glimmer-1", GLIMMER, "shimmer", Set.of(), after(stage, 0.2, () -> shine(stage)));

    assertThat(stage.goal(WISH))
        .isReached()
        .tells("glimmer-1 shimmers in zone-b")
        .neverTells("is set to");
    assertThat(stage.world()).hasNextTo("Cup", "Bob").hasLampAt("lamp-b1", 0);

    stage.kill("cam-a");
    stage.await("cam-a is gone", () -> !stage.platform().presentMembers().contains("cam-a"));
  }

  /** Three-layered architecture, 2 (M20): whoever comes and goes, the platform goes on. */
  @Test
  void tenJoinAndLeaveInAnyOrderAndTheListOfAgentsFollows(Stage stage) {
    Random random = new Random(20);
    SortedMap<String, RatsMember> there = new TreeMap<>();
    for (int change = 1; change <= 10; change++) {
      String id = "glimmer-" + (1 + random.nextInt(3));
      if (there.containsKey(id)) {
        there.remove(id).close();
      } else {
        there.put(
            id,
            joins(
                stage,
                id,
                GLIMMER.replace("glimmer-1", id),
                "shimmer",
                Set.of(),
                after(stage, 0.2, () -> shine(stage))));
      }
      stage.await(
          "the list of agents follows change " + change,
          () -> readyGlimmers(stage).equals(there.keySet()));
      assertThat(stage.goal("(canSee ?camera Bob)")).isReached();
    }
    assertThat(stage.goal(WISH)).isReached();
  }

  private static Set<String> readyGlimmers(Stage stage) {
    return stage.platform().agents().stream()
        .filter(row -> row.phase().equals("ready"))
        .flatMap(row -> row.members().stream())
        .filter(member -> member.startsWith("glimmer"))
        .collect(Collectors.toCollection(TreeSet::new));
  }

  @Test
  void whatWasImpossibleIsPlannedOnceSomebodyOffersIt(Stage stage) {
    List.of("lamp-b1", "lamp-b2", "lamp-b3").forEach(stage::kill);
    assertThat(stage.goal(WISH)).isNotReached().isExplainedBy("illuminance");

    joins(stage, "glimmer-1", GLIMMER, "shimmer", Set.of(), after(stage, 0.2, () -> shine(stage)));

    assertThat(stage.goal(WISH)).isReached().tells("glimmer-1 shimmers in zone-b");
    assertThat(stage.world()).hasNextTo("Cup", "Bob");
  }

  @Test
  void anotherWayOfCarryingSparesTheRobot(Stage stage) {
    joins(
        stage,
        "band-1",
        BAND,
        "waft",
        Set.of("belt"),
        after(stage, 2, () -> stage.world().moveByHand("Cup", besideBob(stage))));

    GoalOutcome outcome = stage.goal(WISH);

    assertThat(outcome).isReached().isConfirmed().tells("band-1 wafts Cup to Bob");
    assertThat(outcome).neverUses("rose");
    assertThat(stage.world()).hasNextTo("Cup", "Bob");
  }

  /**
   * Three-layered architecture, 2 (M22): it need not look for what others have seen before it came.
   */
  @Test
  void whoJoinsUsesWhatWasSeenBefore(Stage stage) {
    assertThat(stage.goal("(canSee ?camera Cup)")).isReached();
    assertThat(stage.goal("(canSee ?camera Bob)")).isReached();
    joins(
        stage,
        "band-1",
        BAND,
        "waft",
        Set.of("belt"),
        after(stage, 2, () -> stage.world().moveByHand("Cup", besideBob(stage))));

    assertThat(stage.goal(WISH))
        .isReached()
        .tells("Plan 1 (cost 2): 1. band-1 wafts Cup to Bob")
        .neverTells("looks for Cup in zone-b");
  }

  private static void shine(Stage stage) {
    stage.world().setAmbient("zone-b", 97);
  }

  private static Position besideBob(Stage stage) {
    Position bob = stage.world().position("Bob").orElseThrow();
    return new Position(bob.x() + 0.4, bob.y(), 0);
  }

  private static Procedure after(Stage stage, double seconds, Runnable deed) {
    return new Procedure() {
      @Override
      public void start(Execution execution) {
        stage
            .clock()
            .schedule(
                Duration.ofMillis((long) (seconds * 1000)),
                "the deed",
                () -> {
                  deed.run();
                  execution.succeed(Map.of());
                });
      }

      @Override
      public CostAnswer cost(Map<String, Object> parameters) {
        return new CostAnswer(Optional.of(seconds), Optional.of(seconds), Optional.empty());
      }
    };
  }

  private static RatsMember joins(
      Stage stage,
      String id,
      String description,
      String feature,
      Set<String> occupies,
      Procedure procedure) {
    MemberProfile.Feature offered =
        new MemberProfile.Feature(
            feature, Set.of(), occupies, false, Optional.empty(), "busy", procedure);
    RatsMember member =
        stage.join(
            new MemberProfile(
                id,
                description,
                Set.of("calm", "busy"),
                "calm",
                Set.of("calm"),
                Map.of(feature, offered)),
            List::of);
    stage.await(id + " joined", () -> stage.platform().presentMembers().contains(id));
    return member;
  }
}
