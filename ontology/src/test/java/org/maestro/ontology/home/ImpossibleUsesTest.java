package org.maestro.ontology.home;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

/** What no device of a home can do with a thing, by what the home states. */
class ImpossibleUsesTest {
  private static final String HOME =
      """
      @prefix : <https://w3id.org/maestro/domain#> .
      @prefix home: <https://example.org/heavy#> .
      @prefix maestro: <https://w3id.org/maestro#> .
      @prefix rdfs: <http://www.w3.org/2000/01/rdf-schema#> .
      <https://example.org/heavy> a maestro:Home .
      home:hall a maestro:Zone ; maestro:outline "0 0, 4 0, 4 4, 0 4" ; maestro:referencePoint "2 2 0" .
      home:Mug a :Item ; :size "%s" ; :mass %s .
      home:rose a :MobileRobot ; :size "0.58 0.38 0.4" ; :speed 0.8 ; :payload 0.5 ; :gripperOpening 0.07 .
      home:tim a :MobileRobot ; :size "0.58 0.38 0.4" ; :speed 0.8 ; :payload 1.5 %s .
      """;

  private static final String CUP = "0.08 0.08 0.1";
  private static final String WIDE_MUG = "0.12 0.13 0.1";

  @Test
  void areNamedWithTheNumbersOfTheNearestWhoCannot() {
    assertThat(ImpossibleUses.of(home(CUP, "2", "; :gripperOpening 0.08")))
        .containsExactly(
            "Nobody can do pick with Mug: the mass of Mug (2 kg) has to be at most the payload of"
                + " tim (1.5 kg), the nearest of 2. Correct the numbers, or add a device that"
                + " can.");
  }

  @Test
  void areNoneWhereOneCan() {
    assertThat(ImpossibleUses.of(home(CUP, "1.2", "; :gripperOpening 0.08"))).isEmpty();
  }

  @Test
  void areThingsTooWideForEveryGripper() {
    assertThat(ImpossibleUses.of(home(WIDE_MUG, "0.3", "; :gripperOpening 0.08")))
        .containsExactly(
            "Nobody can do pick with Mug: the width of Mug (0.12 m) has to be at most the gripper"
                + " opening of tim (0.08 m), the nearest of 2. Correct the numbers, or add a device"
                + " that can.");
  }

  /** Light enough for the one, narrow enough for the other. */
  @Test
  void areThingsThatEachDeviceFailsForAReasonOfItsOwn() {
    assertThat(ImpossibleUses.of(home(CUP, "1", "; :gripperOpening 0.06")))
        .containsExactly(
            "Nobody can do pick with Mug: the mass of Mug (1 kg) has to be at most the payload of"
                + " rose (0.5 kg); the width of Mug (0.08 m) has to be at most the gripper opening"
                + " of tim (0.06 m). Correct the numbers, or add a device that can.");
  }

  @Test
  void areNoneWhereNobodyKnowsHowWideAGripperOpens() {
    assertThat(ImpossibleUses.of(home(WIDE_MUG, "0.3", ""))).isEmpty();
  }

  /** What a device may change some day is no reason. */
  @Test
  void areNoneByNumbersThatAFeatureChanges() {
    String words =
        """
        home:filled a maestro:Fluent ; maestro:arguments ( "?x - Item" ) .
        home:drink a maestro:Action ; maestro:sentence "{self} drinks" ;
          maestro:input [ maestro:name "object" ; maestro:type :Item ] ;
          maestro:precondition "(>= (filled ?object) 1)" ; maestro:effect "(assign (filled ?object) 0)" ;
          maestro:cost "1" .
        home:bot a maestro:Device ; maestro:offers home:drink .
        home:Glass a :Item ; home:filled 0 ; :size "0.05 0.05 0.1" ; :mass 0.1 .
        """;
    assertThat(
            ImpossibleUses.of(
                home(CUP, "0.2", "; :gripperOpening 0.08 . " + words + "home:end a :Item")))
        .isEmpty();
  }

  private static Home home(String size, String mass, String tim) {
    return new HomeLoader().load(HOME.formatted(size, mass, tim), "heavy.ttl");
  }
}
