package org.maestro.ontology.permission;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.maestro.ontology.home.Device;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeFacts;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.sl.Formula;
import org.maestro.sl.SlParser;

/** What somebody asks for, held against what she may have done (ADE, 5; A85). */
class GoalObjectionsTest {
  private static final Optional<String> TOM = Optional.of("Tom");
  private static final Optional<String> MIA = Optional.of("Mia");
  private static final Optional<String> DAVE = Optional.of("Dave");
  private static final Optional<String> STRANGER = Optional.empty();

  private static String evening;
  private static Home home;

  @BeforeAll
  static void read() throws IOException {
    evening =
        Files.readString(Path.of("../scenarios/assembly/src/main/resources/homes/evening.ttl"));
    home = home("");
  }

  private static Home home(String more) {
    return new HomeLoader().load(evening + more, "evening.ttl");
  }

  private static Optional<Objection> objection(Home there, String goal, Optional<String> person) {
    return new GoalObjections(there, new HomeFacts(there))
        .of(SlParser.formula(goal, there.vocabulary()::isFluent), person);
  }

  private static Optional<Objection> objection(String goal, Optional<String> person) {
    return objection(home, goal, person);
  }

  @Test
  void aChildMaySetTheVolumeUpToALimitAndIsToldWhich() {
    assertThat(objection("(= (volume tv) 60)", TOM)).isEmpty();
    Objection objection = objection("(= (volume tv) 61)", TOM).orElseThrow();

    assertThat(objection.limit())
        .hasValueSatisfying(
            limit -> {
              assertThat(limit.relation()).isEqualTo(Formula.Relation.AT_MOST);
              assertThat(limit.number()).isEqualTo(60);
              assertThat(limit.what().name()).isEqualTo("volume");
            });
    assertThat(objection.others()).containsExactly("Dave", "Grandma", "Rose");
    assertThat(objection.permissions()).containsExactly("volume-of-children");
    assertThat(objection.way().device().id()).isEqualTo("tv");
  }

  @Test
  void whoIsNotNamedMayAllAsBefore() {
    assertThat(objection("(= (volume tv) 100)", DAVE)).isEmpty();
    assertThat(objection("(= (volume tv) 100)", STRANGER)).isEmpty();
    assertThat(objection("(switchedOn oven)", DAVE)).isEmpty();
    assertThat(objection("(switchedOn tv)", TOM)).isEmpty();
  }

  @Test
  void aGoalThatLeavesTheNumberOpenIsRefusedWhereNoneMayBe() {
    assertThat(objection("(>= (volume tv) 70)", TOM)).isPresent();
    assertThat(objection("(> (volume tv) 60)", TOM)).isPresent();
    assertThat(objection("(>= (volume tv) 60)", TOM)).isEmpty();
    assertThat(objection("(<= (volume tv) 70)", TOM)).isEmpty();
    assertThat(objection("(>= (targetTemperature livingroom) 24)", TOM)).isPresent();
    assertThat(objection("(>= (targetTemperature livingroom) 22)", TOM)).isEmpty();
  }

  @Test
  void aForbiddenFeatureIsForbiddenInEveryKindOfGoal() {
    for (String goal :
        List.of(
            "(switchedOn oven)",
            "(and (switchedOn tv) (switchedOn oven))",
            "(keep (switchedOn oven))",
            "(at \"18:30\" (switchedOn oven))",
            "(whenever (atHome Rose) (switchedOn oven))",
            "(forall (?o - CookingAppliance) (switchedOn ?o))",
            "(exists (?o - CookingAppliance) (switchedOn ?o))",
            "(or (switchedOn oven) (switchedOn hob))")) {
      assertThat(objection(goal, TOM)).as(goal).isPresent();
      assertThat(objection(goal, DAVE)).as(goal).isEmpty();
    }
    assertThat(objection("(or (switchedOn oven) (switchedOn tv))", TOM)).isEmpty();
    assertThat(objection("(exists (?o - Appliance) (switchedOn ?o))", TOM)).isEmpty();
    assertThat(objection("(not (switchedOn oven))", TOM)).isEmpty();
  }

  @Test
  void whatIsSoAlreadyNeedsNothingThatIsForbidden() {
    assertThat(objection("(not (locked front-door))", TOM)).isEmpty();
    assertThat(objection("(keep (not (locked front-door)))", TOM)).isPresent();
  }

  @Test
  void scriptsAreHeldAgainstItBeforeTheyBegin() {
    assertThat(objection("(serveDrink Scotch Tom)", TOM)).isPresent();
    assertThat(objection("(serveDrink Juice Tom)", TOM)).isEmpty();
    assertThat(objection("(serveDrink Scotch Dave)", DAVE)).isEmpty();
    assertThat(objection("(served Scotch Tom)", TOM)).isPresent();
    assertThat(objection("(served Juice Tom)", TOM)).isEmpty();
  }

  @Test
  void whoIsNamedMoreNarrowlyGoesFirst() {
    Home there =
        home(
            """
            home:mia a maestro:Permission ; maestro:person home:Mia ; maestro:asks :MediaPlayer ;
              maestro:permits :setVolume ; maestro:when "(<= ?volume 30)" .
            home:door a maestro:Permission ; maestro:person "*" ; maestro:asks home:front-door ;
              maestro:forbids :lockDoor .
            home:adults a maestro:Permission ; maestro:person :Adult ; maestro:asks home:front-door ;
              maestro:permits :lockDoor .
            """);

    assertThat(objection(there, "(= (volume tv) 40)", MIA)).isPresent();
    assertThat(objection(there, "(= (volume tv) 40)", TOM)).isEmpty();
    assertThat(objection(there, "(locked front-door)", DAVE)).isEmpty();
    assertThat(objection(there, "(locked front-door)", TOM)).isPresent();
    assertThat(objection(there, "(locked front-door)", STRANGER)).isPresent();
  }

  @Test
  void aConditionMaySpeakOfWhoAsksAndOfWhatIsSo() {
    Home there =
        home(
            """
            home:own a maestro:Permission ; maestro:person :Child ; maestro:asks :Lamp ;
              maestro:forbids :adjustLight ; maestro:when "(not (= ?speaker Mia))" .
            """);

    assertThat(objection(there, "(= (level kitchen-lamp) 1)", TOM)).isPresent();
    assertThat(objection(there, "(= (level kitchen-lamp) 1)", MIA)).isEmpty();
  }

  @Test
  void inTheHomeAsItIsForAPersonALimitIsACondition() {
    Restrictions restrictions = Restrictions.of(home);
    Home toms = restrictions.homeOf(TOM);
    Device tv = home.devices().get("tv");

    assertThat(feature(toms.devices().get("tv"), "setVolume").precondition())
        .isEqualTo(
            SlParser.formula(
                "(and (not (= (volume ?self) ?volume)) (<= ?volume 60))",
                home.vocabulary()::isFluent));
    assertThat(restrictions.homeOf(DAVE).devices()).isEqualTo(home.devices());
    Device oven = home.devices().get("oven");
    assertThat(restrictions.objection(TOM, oven, feature(oven, "switchOn")))
        .hasValueSatisfying(
            objection -> assertThat(objection.others()).containsExactly("Dave", "Grandma", "Rose"));
    assertThat(restrictions.objection(TOM, tv, feature(tv, "setVolume"))).isEmpty();
    assertThat(restrictions.names(TOM, tv, feature(tv, "setVolume")))
        .isEqualTo(Set.of("volume-of-children"));
  }

  private static FeatureType feature(Device device, String name) {
    return device.features().stream()
        .filter(feature -> feature.name().equals(name))
        .findFirst()
        .orElseThrow();
  }
}
