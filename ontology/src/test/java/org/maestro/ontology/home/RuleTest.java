package org.maestro.ontology.home;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;
import org.maestro.sl.SlParser;

/** Rules of a home's file, which a platform holds from its start on. */
class RuleTest {
  private static final String BOB = ShippedHomes.text("bob.ttl");
  private static final String SCRIPT =
      """

      home:light a maestro:Script ; rdfs:label "light" ; maestro:arguments ( "?room - Zone" ) ;
        maestro:body "(achieve (>= (illuminance ?room) 72))" .
      """;

  private static Home load(String rule) {
    return new HomeLoader()
        .load(
            BOB + SCRIPT + "home:evenings a maestro:Rule ; rdfs:label \"light\" " + rule,
            "bob.ttl");
  }

  private static void assertFault(String rule, String problem) {
    assertThatThrownBy(() -> load(rule)).hasMessageContaining(problem);
  }

  @Test
  void aRuleIsNoThingAndBeginsGoals() {
    String goal = "(whenever (in Bob ?z) (light ?z))";
    Home home = load("; maestro:pursues \"" + goal + "\" .");

    assertThat(home.rules()).containsOnlyKeys("evenings");
    Rule rule = home.rules().get("evenings");
    assertThat(rule.label()).isEqualTo("light");
    assertThat(rule.goal()).isEqualTo(SlParser.formula(goal));
    assertThat(home.individuals()).doesNotContainKey("evenings");
    assertThat(home.withScripts(home.scripts()).rules()).isEqualTo(home.rules());
  }

  @Test
  void whatBeginsNothingOrAtNoTimeIsAFault() {
    assertFault(".", "evenings maestro:pursues is missing; write what is to begin when");
    assertFault(
        "; maestro:pursues \"(in Bob zone-a)\" .", "is bound to no time and no event; write when");
    assertFault(
        "; maestro:pursues \"(after 5 (open door-ab))\" , \"(after 6 (open door-ab))\" .",
        "is stated more than once; make a rule of each");
    assertFault("; maestro:pursues \"(whenever\" .", "is not MAESTRO-SL");
  }

  @Test
  void whatARuleSpeaksOfHasToBeThere() {
    assertFault(
        "; maestro:pursues \"(whenever (inn Bob ?z) (light ?z))\" .",
        "uses the unknown predicate inn");
    assertFault("; maestro:pursues \"(whenever (in Bobb ?z) (light ?z))\" .", "names Bobb");
    assertFault(
        "; maestro:pursues \"(whenever (in Bob ?z) (light))\" .",
        "gives light 0 arguments; write (run light ?room - Zone)");
    assertFault(
        "; maestro:pursues \"(whenever (in Bob ?z) (light ?y))\" .",
        "begins a goal with ?y, of which no condition of it speaks; write a name in its place");
    assertFault(
        "; maestro:pursues \"(at \\\"22:00\\\" :every \\\"day\\\" (open door-cd))\" .",
        "names door-cd");
  }

  @Test
  void aRuleIsNotCalledAsGoalsAre() {
    assertThatThrownBy(
            () ->
                new HomeLoader()
                    .load(
                        BOB
                            + "home:G7 a maestro:Rule ; maestro:pursues \"(after 5 (open"
                            + " door-ab))\" .",
                        "bob.ttl"))
        .hasMessageContaining("has a name as goals have; give the rule another name");
  }
}
