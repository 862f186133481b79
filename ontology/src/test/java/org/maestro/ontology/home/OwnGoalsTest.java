package org.maestro.ontology.home;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.Duration;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.maestro.sl.SlParser;

/** Goals that devices, classes and group agents have of their own accord. */
class OwnGoalsTest {
  private static final String BOB = ShippedHomes.text("bob.ttl");
  private static final String GROUP =
      """

      home:keeper a maestro:GroupAgent ; rdfs:label "keeper of B" ; maestro:container "lights" ;
        maestro:member home:lamp-b1 , home:lux-b ; maestro:memberWhen "(inside ?member zone-b)" ;
        maestro:pursues "(keep (>= (illuminance zone-b) 72))" .
      """;

  @Test
  void aGroupHasMembersAndGoals() {
    Group keeper = load(BOB + GROUP).groups().get("keeper");

    assertThat(keeper.members()).containsExactly("lamp-b1", "lux-b");
    assertThat(keeper.memberWhen()).contains(SlParser.formula("(inside ?member zone-b)"));
    assertThat(keeper.pursues())
        .containsExactly(SlParser.formula("(keep (>= (illuminance zone-b) 72))"));
    assertThat(keeper.container()).contains("lights");
  }

  @Test
  void aDeviceHasTheGoalsOfItsClassToo() {
    String goal = "(>= (illuminance zone-b) 72)";
    String ofClass = "(keep (not (= (level ?self) 0.25)))";
    Home home =
        load(
            BOB.replace(":power 17 .", ":power 17 ; maestro:pursues \"" + goal + "\" .")
                + "\n:Lamp maestro:pursues \""
                + ofClass
                + "\" .");

    assertThat(home.devices().get("lamp-b2").pursues())
        .containsExactly(SlParser.formula(ofClass), SlParser.formula(goal));
    assertThat(home.devices().get("lamp-b1").pursues()).containsExactly(SlParser.formula(ofClass));
    assertThat(home.devices().get("lux-b").pursues()).isEmpty();
    assertThat(
            new DescriptionReader(home.vocabulary())
                .read(new DescriptionWriter(home).write(home.devices().get("lamp-b2")), "lamp-b2"))
        .isEqualTo(home.devices().get("lamp-b2"));
  }

  @Test
  void aDeviceSaysWhatItsGoalsAreWorth() {
    Home home =
        load(
            BOB.replace(
                    ":power 17 .",
                    ":power 17 ; maestro:pursues \"(>= (illuminance zone-b) 72)\" ;"
                        + " maestro:benefit \"(* 40 (level ?self))\" ;"
                        + " maestro:allowed \"PT10M\" .")
                + "\n:Lamp maestro:benefit 30 ; maestro:chance 0.5 ;"
                + " maestro:pursues \"(keep (not (= (level ?self) 0.25)))\" .");
    Device lamp = home.devices().get("lamp-b2");

    assertThat(lamp.worth())
        .isEqualTo(
            new StatedWorth(
                Optional.of(SlParser.expression("(* 40 (level ?self))")),
                Optional.of(0.5),
                Optional.of(Duration.ofMinutes(10))));
    assertThat(home.devices().get("lamp-b1").worth().benefit()).contains(SlParser.expression("30"));
    assertThat(lamp.individual().properties()).doesNotContainKeys("benefit", "chance", "allowed");
    assertThat(
            new DescriptionReader(home.vocabulary())
                .read(new DescriptionWriter(home).write(lamp), "lamp-b2"))
        .isEqualTo(lamp);
  }

  @Test
  void aFaultyWorthOfADeviceIsNamedWithItsCure() {
    String pursues = "maestro:pursues \"(>= (illuminance zone-b) 72)\" ; ";
    assertWorth("maestro:benefit 30", "says what its goals are worth, and has none; state one by");
    assertWorth(pursues + "maestro:benefit -3", "is less than nothing");
    assertWorth(pursues + "maestro:benefit \"(levl ?self)\"", "uses the unknown fluent levl");
    assertWorth(pursues + "maestro:benefit 1 ; maestro:chance 2", "is not a number from 0 to 1");
    assertWorth(pursues + "maestro:benefit 1 , 2", "is stated more than once; keep one");
  }

  private static void assertWorth(String stated, String problem) {
    assertThatThrownBy(() -> load(BOB.replace(":power 17 .", ":power 17 ; " + stated + " .")))
        .hasMessageContaining(problem);
  }

  @Test
  void aFaultyGoalIsNamedWithItsCure() {
    assertFault("\"(keep (>= (illuminanse zone-b) 72))\"", "uses the unknown fluent illuminanse");
    assertFault("\"(keep (>= (illuminance zone-c) 72))\"", "names zone-c, which is not described");
    assertFault("\"(keep (>= (illuminance zone-b) 72)\"", "is not MAESTRO-SL");
    assertFault("72", "is not a text; write the goal in MAESTRO-SL in quotes");
  }

  @Test
  void aGroupWithoutGoalOrWithAStrangeMemberIsAFault() {
    assertThatThrownBy(() -> load(BOB + GROUP.replaceAll(";\\s+maestro:pursues [^.]*\\.", ".")))
        .hasMessageContaining("has no maestro:pursues");
    assertThatThrownBy(() -> load(BOB + GROUP.replace("home:lamp-b1 ,", "home:lamp-c9 ,")))
        .hasMessageContaining("lamp-c9 is not described in this home");
  }

  private static final String SCRIPTS =
      """

      home:light a maestro:Script ; rdfs:label "light" ; maestro:arguments ( "?room - Zone" ) ;
        maestro:body "(foreach (?l - Lamp) (inside ?l ?room) (do adjustLight ?l :level 1))" .
      home:fetchIt a maestro:Script ; rdfs:label "fetch" ; maestro:body "(run bringIt)" .
      home:bringIt a maestro:Script ; rdfs:label "bring it" ; maestro:body "(achieve (nextTo Cup Bob))" .
      """;
  private static final String KEEP = "\"(keep (>= (illuminance zone-b) 72))\"";

  @Test
  void aGroupMayRunScriptsAndSayWhatItsGoalsAreWorth() {
    Group keeper =
        load(BOB
                + SCRIPTS
                + GROUP.replace(
                    KEEP, "\"(light zone-b)\" ; maestro:benefit 60 ; maestro:plans false"))
            .groups()
            .get("keeper");

    assertThat(keeper.pursues()).containsExactly(SlParser.formula("(light zone-b)"));
    assertThat(keeper.worth().benefit()).contains(SlParser.expression("60"));
    assertThat(keeper.plans()).isFalse();
  }

  @Test
  void aScriptThatAGroupRunsIsCheckedAsAnyRun() {
    assertScript(
        "\"(light zone-b zone-a)\"", "gives light 2 arguments; write (run light ?room - Zone)");
    assertScript("\"(light Bob)\"", "gives Bob for ?room of light, which cannot be that");
    assertScript("\"(light zone-b)\" ; maestro:benefit \"(* 2 ?lamps)\"", "?lamps");
  }

  @Test
  void whoMakesNoPlansRunsScriptsOfCallsOnly() {
    assertScript(
        KEEP + " ; maestro:plans false",
        "states a goal that is to be planned for, and its agent makes no plans (maestro:plans"
            + " false); name a script, or leave maestro:plans out");
    assertScript(
        "\"(fetchIt)\" ; maestro:plans false",
        "runs fetchIt, which achieves something by a plan, and its agent makes none (maestro:plans"
            + " false); write its steps with do, or leave maestro:plans out");
  }

  private static void assertScript(String goal, String problem) {
    assertThatThrownBy(() -> load(BOB + SCRIPTS + GROUP.replace(KEEP, goal)))
        .hasMessageContaining(problem);
  }

  private static void assertFault(String goal, String problem) {
    assertThatThrownBy(
            () -> load(BOB + GROUP.replace("\"(keep (>= (illuminance zone-b) 72))\"", goal)))
        .hasMessageContaining(problem);
  }

  private static Home load(String text) {
    return new HomeLoader().load(text, "test.ttl");
  }
}
