package org.maestro.knowledge;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.maestro.knowledge.api.FeatureRun;
import org.maestro.knowledge.api.KnowledgeException;
import org.maestro.knowledge.api.Source;
import org.maestro.ontology.home.DescriptionReader;
import org.maestro.ontology.home.Device;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.rats.time.SteppedClock;
import org.maestro.sl.Evaluation;
import org.maestro.sl.SlParser;
import org.maestro.sl.Term;
import org.maestro.sl.Truth;

/** A vending machine brings its own words to Bob's home, and tells which cans are in it. */
class ThingsOfDevicesTest {

  private static final String VENDING =
      """
      {"@context": ["https://w3id.org/maestro/context.jsonld", {"v": "https://example.org/vending#"}],
       "id": "v:vending-1", "type": "maestro:Device",
       "offers": {"id": "v:sell", "type": "maestro:Task",
         "input": [{"name": "can", "types": ["v:Can"]}, {"name": "buyer", "types": ["domain:Person"]}],
         "precondition": "(stocked ?can ?self)",
         "effect": "(and (sold ?can ?buyer) (not (stocked ?can ?self)))", "cost": "1"},
       "brings": [
         {"id": "v:Can", "type": "owl:Class", "subClassOf": "domain:Item"},
         {"id": "v:stocked", "type": "maestro:Predicate", "arguments": ["?c - Can", "?d - Device"]},
         {"id": "v:sold", "type": "maestro:Predicate", "arguments": ["?c - Can", "?p - Person"]}]}
      """;

  private final Home bob =
      new HomeLoader().load(Path.of("../scenarios/assembly/src/main/resources/homes/bob.ttl"));
  private final CollectiveKnowledge knowledge = new CollectiveKnowledge(bob, new SteppedClock());
  private final Device vending = DescriptionReader.of(bob).read(VENDING, "vending-1");

  @AfterEach
  void close() {
    knowledge.close();
  }

  private void tell(String... facts) {
    knowledge.state(new Source(Source.Kind.STATED, "vending-1"), List.of(facts));
  }

  private Truth holds(String formula) {
    return new Evaluation(knowledge.snapshot()).truth(SlParser.formula(formula), Map.of());
  }

  @Test
  void aThingIsThereWhileItsDeviceTellsIt() {
    knowledge.describe(vending);
    tell("(Can can-1)", "(stocked can-1 vending-1)");

    assertThat(knowledge.home().individuals().get("can-1").classes()).contains("Can", "Item");
    assertThat(holds("(exists (?c - Can) (stocked ?c vending-1))")).isEqualTo(Truth.TRUE);
    tell("(Can can-2)", "(stocked can-2 vending-1)");
    assertThat(knowledge.home().individuals()).containsKey("can-2").doesNotContainKey("can-1");
    tell();
    assertThat(knowledge.home().individuals()).doesNotContainKey("can-2");
    assertThat(holds("(exists (?c - Can) (stocked ?c vending-1))")).isEqualTo(Truth.FALSE);
  }

  @Test
  void aThingThatLeftStaysAsLongAsSomethingIsKnownOfIt() {
    knowledge.describe(vending);
    tell("(Can can-1)", "(stocked can-1 vending-1)");
    sell();
    tell();

    assertThat(knowledge.home().individuals()).containsKey("can-1");
    assertThat(holds("(exists (?c - Can) (sold ?c Bob))")).isEqualTo(Truth.TRUE);
  }

  @Test
  void aSaleThatComesToBeKnownAfterTheStateThatFollowedItCountsToo() {
    knowledge.describe(vending);
    tell("(Can can-1)", "(stocked can-1 vending-1)");
    tell();
    assertThat(knowledge.home().individuals()).doesNotContainKey("can-1");
    sell();

    assertThat(holds("(exists (?c - Can) (sold ?c Bob))")).isEqualTo(Truth.TRUE);
    tell();
    assertThat(knowledge.home().individuals()).containsKey("can-1");
  }

  private void sell() {
    knowledge.learn(
        new FeatureRun(
            "vending-1",
            vending.features().get(0),
            Map.of("can", new Term.Name("can-1"), "buyer", new Term.Name("Bob")),
            true,
            Map.of(),
            List.of()));
  }

  @Test
  void aThingOfSomebodyElseIsNotTakenOver() {
    knowledge.describe(vending);
    tell("(Item Cup)", "(Person vending-1)", "(Nonsense x-1)");

    assertThat(knowledge.home().individuals().get("Cup")).isEqualTo(bob.individuals().get("Cup"));
    assertThat(knowledge.home().individuals()).doesNotContainKey("x-1");
    tell();
    assertThat(knowledge.home().individuals()).containsKey("Cup");
  }

  @Test
  void whatAnotherDeclaresOtherwiseIsRefusedWithAReason() {
    knowledge.describe(vending);
    Device other =
        DescriptionReader.of(bob)
            .read(
                VENDING
                    .replace("vending-1", "vending-2")
                    .replace("example.org/vending", "example.com/other"),
                "vending-2");

    assertThatThrownBy(() -> knowledge.describe(other))
        .isInstanceOf(KnowledgeException.class)
        .hasMessageContaining(
            "vending-2 declares the word Can, which vending-1 declares otherwise");
    assertThat(knowledge.home().devices()).doesNotContainKey("vending-2");
  }

  @Test
  void whatItToldStaysWhenItDescribesItselfAgain() {
    knowledge.describe(vending);
    tell("(Can can-1)");
    knowledge.describe(DescriptionReader.of(bob).read(VENDING + " ", "vending-1"));

    assertThat(knowledge.home().individuals()).containsKey("can-1");
  }

  /** Nobody but the device knew it, and the device comes back without it. */
  @Test
  void whatAFormerLifeSaidOfOthersIsWithdrawnByTheFirstWordOfTheNext() {
    knowledge.describe(vending);
    tell("(Can can-1)", "(stocked can-1 vending-1)", "(sold can-7 Bob)");
    knowledge.lost("vending-1");
    assertThat(holds("(sold can-7 Bob)")).isEqualTo(Truth.TRUE);
    knowledge.describe(vending);
    tell("(stocked can-1 vending-1)");

    assertThat(holds("(sold can-7 Bob)")).isEqualTo(Truth.FALSE);
    assertThat(holds("(stocked can-1 vending-1)")).isEqualTo(Truth.TRUE);
  }

  @Test
  void aThingThatAnotherTellsByNowIsNotTakenBack() {
    knowledge.describe(vending);
    Device other =
        DescriptionReader.of(bob).read(VENDING.replace("vending-1", "vending-2"), "vending-2");
    knowledge.describe(other);
    tell("(Can can-1)");
    tell();
    knowledge.state(new Source(Source.Kind.STATED, "vending-2"), List.of("(Can can-1)"));
    sell();
    tell("(stocked can-1 vending-1)");

    assertThat(holds("(sold can-1 Bob)")).isEqualTo(Truth.TRUE);
    assertThat(holds("(stocked can-1 vending-1)")).isEqualTo(Truth.TRUE);
  }

  @Test
  void aThingThatIsCalledLikeADeviceGivesWay() {
    knowledge.describe(vending);
    tell("(Can vending-2)");
    knowledge.describe(
        DescriptionReader.of(bob).read(VENDING.replace("vending-1", "vending-2"), "vending-2"));
    tell("(Can vending-2)", "(stocked can-1 vending-1)");
    tell();

    assertThat(knowledge.home().individuals().get("vending-2").classes()).contains("Device");
  }

  @Test
  void aPermissionDoesNotComeAsAThing() {
    String withClass =
        VENDING.replace(
            "{\"id\": \"v:Can\"",
            "{\"id\": \"v:Pass\", \"type\": \"owl:Class\", \"subClassOf\": [\"maestro:Thing\", \"maestro:Permission\"]},"
                + " {\"id\": \"v:Can\"");
    knowledge.describe(DescriptionReader.of(bob).read(withClass, "vending-1"));
    tell("(Pass x-1)");

    assertThat(knowledge.home().individuals()).doesNotContainKey("x-1");
  }
}
