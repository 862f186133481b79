package org.maestro.ontology.home;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.ontology.vocabulary.PredicateDeclaration;
import org.maestro.sl.SlParser;
import org.maestro.sl.SlPrinter;

/** Descriptions bring the words that they need, and things; what means the same is one word. */
class WordsOfMakersTest {

  private static final String KETTLE =
      """
      {"@context": ["https://w3id.org/maestro/context.jsonld", {"k": "https://example.org/kitchen#"}],
       "id": "k:kettle-1", "type": "k:Kettle",
       "offers": {"id": "k:brew", "type": "maestro:Task", "sentence": "{self} brews {drink} for {guest}",
         "input": [{"name": "drink", "types": ["k:Drink"]}, {"name": "guest", "types": ["k:Guest"]}],
         "precondition": "(and (>= (filled ?self) 1) (not (exists (?d - Drink) (served ?d ?guest))))",
         "effect": "(and (served ?drink ?guest) (decrease (filled ?self) 1))", "cost": "3"},
       "brings": [
         {"id": "k:Kettle", "type": "owl:Class", "subClassOf": "maestro:Device"},
         {"id": "k:Drink", "type": "owl:Class", "subClassOf": "maestro:Thing"},
         {"id": "k:Guest", "type": "owl:Class", "equivalentClass": "domain:Person"},
         {"id": "k:served", "type": ["maestro:Predicate", "maestro:Observable"],
          "arguments": ["?d - Drink", "?g - Guest"]},
         {"id": "k:filled", "type": "maestro:Fluent", "arguments": ["?k - Kettle"], "least": 0},
         {"id": "k:tea", "type": "k:Drink", "label": "tea"}]}
      """;

  private static final String OTHER =
      """
      {"@context": ["https://w3id.org/maestro/context.jsonld", {"t": "https://example.com/tables#"}],
       "id": "t:table-1", "type": "maestro:Device",
       "offers": {"id": "t:clear", "type": "maestro:Task", "input": {"name": "cup", "types": ["t:Beverage"]},
         "precondition": "(exists (?p - Person) (broughtTo ?cup ?p))",
         "effect": "(cleared ?cup)", "cost": "1"},
       "brings": [
         {"id": "t:Beverage", "type": "owl:Class", "subClassOf": "maestro:Thing"},
         {"id": "t:broughtTo", "type": ["maestro:Predicate", "maestro:Observable"],
          "arguments": ["?d - Beverage", "?g - Person"]},
         {"id": "t:cleared", "type": "maestro:Predicate", "arguments": ["?d - Beverage"]}]}
      """;

  private static final String BRIDGE =
      """
      <https://example.org/kitchen#Drink> <http://www.w3.org/2002/07/owl#equivalentClass> <https://example.com/tables#Beverage> .
      <https://example.org/kitchen#served> <http://www.w3.org/2002/07/owl#equivalentProperty> <https://example.com/tables#broughtTo> .
      """;

  private final Home bob = ShippedHomes.bob();

  private static Device read(Home home, String description, String member) {
    return DescriptionReader.of(home).read(description, member);
  }

  private static FeatureType feature(Device device) {
    return device.features().get(0);
  }

  @Test
  void aDeviceBringsClassesPredicatesFluentsAndThings() {
    Device kettle = read(bob, KETTLE, "kettle-1");

    assertThat(kettle.individual().classes()).containsExactly("Device", "Kettle");
    assertThat(kettle.extension().words().predicates().keySet())
        .containsExactly("filled", "served");
    PredicateDeclaration served = kettle.extension().words().predicates().get("served");
    assertThat(served.observable()).isTrue();
    assertThat(kettle.extension().things().keySet()).containsExactly("tea");
    Home joined = bob.with(kettle);
    assertThat(joined.individuals().get("tea").classes()).containsExactly("Drink", "Thing");
    assertThat(joined.vocabulary().isFluent("filled")).isTrue();
    assertThat(joined.vocabulary().isA("Kettle", "Device")).isTrue();
  }

  @Test
  void aFeatureWithoutASentenceIsToldWithItsInputs() {
    assertThat(feature(read(bob, OTHER, "table-1")).sentence())
        .isEqualTo("{self} runs clear ({cup})");
  }

  @Test
  void aWordThatMeansOneOfTheHomesIsThatOne() {
    Device kettle = read(bob, KETTLE, "kettle-1");

    assertThat(feature(kettle).inputs().get(1).types()).containsExactly("Person");
    assertThat(
            kettle.extension().words().predicates().get("served").parameters().get(1).className())
        .contains("Person");
    assertThat(kettle.extension().words().classes()).doesNotContainKey("Guest");
    assertThat(kettle.extension().synonyms().translated("(Guest Bob)")).isEqualTo("(Person Bob)");
  }

  @Test
  void aDurationThatIsNoneIsToldByItsProperty() {
    String faulty =
        KETTLE.replace(
            "\"arguments\": [\"?d - Drink\"",
            "\"validFor\": \"5\", \"arguments\": [\"?d - Drink\"");

    assertThatThrownBy(() -> read(bob, faulty, "kettle-1"))
        .hasMessageContaining("served validFor \"5\"")
        .hasMessageContaining("is not a duration; write days to seconds, such as PT10M")
        .hasMessageNotContaining("Lexical form");
  }

  @Test
  void whoAsksInAMakersOwnWordIsToldTheOneThatAllUse() {
    Home bridged = new HomeLoader().load(ShippedHomes.text("bob.ttl") + BRIDGE, "bob.ttl");
    Home joined =
        bridged.with(read(bridged, KETTLE, "kettle-1")).with(read(bridged, OTHER, "table-1"));
    StatementCheck check = new StatementCheck(joined, "The goal");

    assertThat(check.fault(SlParser.formula("(served tea Bob)")))
        .contains(
            "The goal uses the unknown predicate served; write broughtTo, as it is called here.");
    assertThat(check.fault(SlParser.formula("(exists (?g - Guest) (broughtTo tea ?g))")))
        .contains("The goal uses the unknown class Guest; write Person, as it is called here.");
  }

  @Test
  void twoMakersThatNeverMetAreBridgedByTheHome() {
    Home bridged = new HomeLoader().load(ShippedHomes.text("bob.ttl") + BRIDGE, "bob.ttl");
    Device kettle = read(bridged, KETTLE, "kettle-1");
    Device table = read(bridged, OTHER, "table-1");
    Home joined = bridged.with(kettle);

    assertThat(bridged.individuals()).doesNotContainKeys("Drink", "Beverage", "served");
    assertThat(joined.contradiction(table)).isEmpty();
    assertThat(SlPrinter.print(feature(kettle).effect())).contains("(broughtTo ?drink ?guest)");
    assertThat(SlPrinter.print(feature(table).precondition()))
        .isEqualTo("(exists (?p - Person) (broughtTo ?cup ?p))");
    assertThat(joined.with(table).individuals().get("tea").classes()).contains("Beverage");
    assertThat(kettle.extension().synonyms().translated("(served tea Bob)"))
        .isEqualTo("(broughtTo tea Bob)");
  }

  /** The table's maker knows the kettle's; the kettle's knows nobody. */
  private static final String KNOWING =
      OTHER
          .replace(
              "{\"id\": \"t:Beverage\", ",
              "{\"id\": \"t:Beverage\", \"equivalentClass\": \"https://example.org/kitchen#Drink\", ")
          .replace(
              "{\"id\": \"t:broughtTo\", ",
              "{\"id\": \"t:broughtTo\", \"equivalentProperty\":"
                  + " \"https://example.org/kitchen#served\", ");

  @Test
  void aMakerBridgesToAnotherInEitherOrder() {
    Device kettle = read(bob, KETTLE, "kettle-1");
    Device table = read(bob, KNOWING, "table-1");

    assertThat(bob.with(kettle).contradiction(table)).isEmpty();
    assertThat(bob.with(table).contradiction(kettle)).isEmpty();
    for (Home joined : List.of(bob.with(kettle).with(table), bob.with(table).with(kettle))) {
      assertThat(joined.vocabulary().predicates())
          .containsKey("served")
          .doesNotContainKey("broughtTo");
      assertThat(joined.vocabulary().predicates().get("served"))
          .isEqualTo(kettle.extension().words().predicates().get("served"));
      assertThat(joined.vocabulary().classes()).containsKey("Drink").doesNotContainKey("Beverage");
    }
    assertThat(SlPrinter.print(feature(table).precondition()))
        .isEqualTo("(exists (?p - Person) (served ?cup ?p))");
    assertThat(table.extension().synonyms().translated("(broughtTo tea Bob)"))
        .isEqualTo("(served tea Bob)");
  }

  @Test
  void aClassMayBeUnderAnothersClassThatIsDeclaredToo() {
    String milk =
        ",\n   {\"id\": \"t:milk\", \"type\": \"t:Beverage\"},"
            + "{\"id\": \"https://example.org/kitchen#Drink\", \"type\": \"owl:Class\","
            + " \"subClassOf\": \"maestro:Thing\"}]}";
    String under =
        OTHER
            .replace(
                "\"subClassOf\": \"maestro:Thing\"",
                "\"subClassOf\": [\"maestro:Thing\", \"https://example.org/kitchen#Drink\"]")
            .replace("]}\n", milk + "\n");
    Device table = read(bob, under, "table-1");
    Home joined = bob.with(table).with(read(bob, KETTLE, "kettle-1"));

    assertThat(joined.vocabulary().isA("Beverage", "Drink")).isTrue();
    assertThat(joined.individuals().get("milk").classes()).contains("Beverage", "Drink", "Thing");
  }

  @Test
  void howItsMakerDeclaresAWordCountsAndNotWhoBridgesToIt() {
    Device kettle = read(bob, KETTLE, "kettle-1");
    Device careless =
        read(
            bob,
            KNOWING.replace(
                "[\"maestro:Predicate\", \"maestro:Observable\"]", "\"maestro:Predicate\""),
            "table-1");

    assertThat(bob.with(careless).contradiction(kettle)).isEmpty();
    assertThat(bob.with(careless).with(kettle).vocabulary().predicates().get("served").observable())
        .isTrue();
    assertThat(bob.with(kettle).with(careless).vocabulary().predicates().get("served").observable())
        .isTrue();
  }

  @Test
  void anotherNumberOfArgumentsIsNotTheSame() {
    Device kettle = read(bob, KETTLE, "kettle-1");
    Device wrong =
        read(
            bob,
            KNOWING
                .replace("\"?d - Beverage\", \"?g - Person\"", "\"?d - Beverage\"")
                .replace("(exists (?p - Person) (broughtTo ?cup ?p))", "(broughtTo ?cup)"),
            "table-1");

    assertThat(bob.with(kettle).contradiction(wrong))
        .hasValueSatisfying(
            reason ->
                assertThat(reason.sentence("table-1"))
                    .contains(
                        "table-1 declares the word served (in its own words broughtTo), which"
                            + " kettle-1 declares otherwise"));
  }

  @Test
  void twoThatTakeEachOthersWordsAreToldSo() {
    String mutual =
        KETTLE.replace(
            "{\"id\": \"k:served\", ",
            "{\"id\": \"k:served\", \"equivalentProperty\":"
                + " \"https://example.com/tables#broughtTo\", ");
    Device table = read(bob, KNOWING, "table-1");

    assertThat(bob.with(table).contradiction(read(bob, mutual, "kettle-1")))
        .hasValueSatisfying(
            reason ->
                assertThat(reason.sentence("kettle-1"))
                    .contains("says that its served is a word of table-1, which says the same")
                    .contains("say it in one of both descriptions"));
  }

  @Test
  void whoSeesOnlyTheWordsOfTheHomeReadsTheSame() {
    Home bridged = new HomeLoader().load(ShippedHomes.text("bob.ttl") + BRIDGE, "bob.ttl");
    DescriptionReader elsewhere =
        new DescriptionReader(new HomeLoader().vocabularyWith(bridged.words()), bridged.words());

    assertThat(elsewhere.read(KETTLE, "kettle-1")).isEqualTo(read(bridged, KETTLE, "kettle-1"));
  }

  @Test
  void twoOfTheSameMakerBringTheSame() {
    Home joined = bob.with(read(bob, KETTLE, "kettle-1"));
    Device second = read(bob, KETTLE.replace("kettle-1", "kettle-2"), "kettle-2");

    assertThat(joined.contradiction(second)).isEmpty();
    assertThat(joined.with(second).with(read(bob, withoutTea(KETTLE), "kettle-1")).individuals())
        .containsKey("tea");
    assertThat(joined.with(read(bob, withoutTea(KETTLE), "kettle-1")).individuals())
        .doesNotContainKey("tea");
  }

  private static String withoutTea(String description) {
    return description.replace(
        ",\n   {\"id\": \"k:tea\", \"type\": \"k:Drink\", \"label\": \"tea\"}", "");
  }

  @Test
  void whatContradictsIsRefused() {
    Home joined = bob.with(read(bob, KETTLE, "kettle-1"));
    Device other =
        read(
            bob,
            OTHER.replace("t:broughtTo", "t:served").replace("broughtTo", "served"),
            "table-1");
    assertThat(joined.contradiction(other))
        .hasValueSatisfying(
            reason ->
                assertThat(reason.sentence("table-1"))
                    .contains(
                        "table-1 declares the word served, which kettle-1 declares otherwise (IRI:"
                            + " https://example.com/tables#served here,"
                            + " https://example.org/kitchen#served there; arguments: (served ?1 -"
                            + " Beverage ?2 - Person) here, (served ?1 - Drink ?2 - Person) there)"));

    Device rose = read(bob, KETTLE.replace("\"id\": \"k:tea\"", "\"id\": \"k:rose\""), "kettle-1");
    assertThat(bob.contradiction(rose))
        .hasValueSatisfying(
            reason -> assertThat(reason.problem()).contains("there is another rose here already"));
  }

  @Test
  void faultsOfWordsAreTold() {
    faulty("k:served", "k:in", "in has the local name of https://w3id.org/maestro/domain#in");
    faulty("\"?d - Drink\", \"?g", "\"?d - Drnk\", \"?g", "write Drink, if that is meant");
    faulty(
        "(served ?drink ?guest) (decrease",
        "(served ?drink) (decrease",
        "gives served 1 arguments");
    faulty(
        "\"type\": \"maestro:Fluent\",",
        "\"type\": \"maestro:Fluent\", \"equivalentProperty\": \"domain:pathLength\",",
        "pathLength has 2 arguments, and filled, which is said to be the same, has 1");
    faulty("\"id\": \"k:tea\"", "\"id\": \"domain:Person\"", "Person is not for kettle-1");
    faulty(
        "\"k:Drink\", \"type\": \"owl:Class\", \"subClassOf\": \"maestro:Thing\"",
        "\"k:Drink\", \"type\": \"owl:Class\", \"subClassOf\": \"https://example.com/tables#Beverage\"",
        "tea is of no class that is under maestro:Thing");
    faulty("\"type\": \"k:Drink\", ", "", "tea is not for kettle-1 to describe");
  }

  private void faulty(String right, String wrong, String told) {
    assertThat(KETTLE).contains(right);
    assertThatThrownBy(() -> read(bob, KETTLE.replace(right, wrong), "kettle-1"))
        .isInstanceOf(HomeFaultException.class)
        .satisfies(
            fault ->
                assertThat(((HomeFaultException) fault).faults())
                    .map(Object::toString)
                    .anyMatch(sentence -> sentence.contains(told)));
  }

  @Test
  void howArgumentsAreCalledAndWhatPeopleReadIsNoContradiction() {
    Home bridged = new HomeLoader().load(ShippedHomes.text("bob.ttl") + BRIDGE, "bob.ttl");
    String labelled =
        KETTLE
            .replace("\"id\": \"k:served\",", "\"id\": \"k:served\", \"label\": \"served to\",")
            .replace("\"?d - Drink\", \"?g - Guest\"", "\"?drink - Drink\", \"?guest - Guest\"");

    assertThat(
            bridged
                .with(read(bridged, labelled, "kettle-1"))
                .contradiction(read(bridged, OTHER, "table-1")))
        .isEmpty();
  }

  @Test
  void aClassAndAPredicateOfOneNameContradict() {
    Home joined = bob.with(read(bob, KETTLE, "kettle-1"));
    Device table =
        read(bob, OTHER.replace("t:cleared", "t:Drink").replace("(cleared", "(Drink"), "table-1");

    assertThat(joined.contradiction(table)).isPresent();
  }

  @Test
  void whatHasASayInTheHomeIsNotBrought() {
    for (String type :
        new String[] {"maestro:Permission", "maestro:Wall", "maestro:Zone", "maestro:GroupAgent"}) {
      faulty(
          "\"type\": \"k:Drink\", \"label\"",
          "\"type\": [\"k:Drink\", \"" + type + "\"], \"label\"",
          "tea is of classes that a device does not bring");
    }
    faulty(
        "\"type\": \"k:Kettle\",",
        "\"type\": [\"k:Kettle\", \"maestro:Permission\"], \"maestro:caller\": \"*\",",
        "these are the home's to say");
    faulty(
        "\"k:Drink\", \"type\": \"owl:Class\", \"subClassOf\": \"maestro:Thing\"",
        "\"k:Drink\", \"type\": \"owl:Class\", \"subClassOf\": [\"maestro:Thing\", \"maestro:Permission\"]",
        "tea is of classes that a device does not bring");
  }

  @Test
  void aWordThatFollowsFromItselfIsRefused() {
    faulty(
        "\"arguments\": [\"?d - Drink\", \"?g - Guest\"]",
        "\"arguments\": [\"?d - Drink\", \"?g - Guest\"], \"derivedWhen\": \"(not (served ?d ?g))\"",
        "follows from itself");
  }

  @Test
  void anAgeThatNoClockHasIsRefused() {
    faulty(
        "\"arguments\": [\"?d - Drink\", \"?g - Guest\"]",
        "\"arguments\": [\"?d - Drink\", \"?g - Guest\"], \"validFor\": \"P1000000D\"",
        "is no age that a fact can have");
  }

  @Test
  void aListWithoutEndIsReadToItsFirstRepetition() {
    String circle =
        """
        @prefix k: <https://example.org/kitchen#> .
        @prefix m: <https://w3id.org/maestro#> .
        @prefix rdf: <http://www.w3.org/1999/02/22-rdf-syntax-ns#> .
        k:bell-1 a m:Device .
        k:odd a m:Predicate ; m:arguments _:l .
        _:l rdf:first "?x" ; rdf:rest _:l .
        """;

    assertThat(read(bob, circle, "bell-1").extension().words().predicates()).containsKey("odd");
  }

  @Test
  void aDeviceIsNotCalledLikeAPlaceAndGivesItsNameToNoThing() {
    Device zone = read(bob, KETTLE.replace("kettle-1", "zone-b"), "zone-b");
    assertThat(bob.contradiction(zone)).isPresent();
    Device rose =
        read(bob, KETTLE.replace("\"id\": \"k:tea\"", "\"id\": \"k:kettle-9\""), "kettle-1");
    Home joined = bob.with(rose);
    Device kettle = read(bob, withoutTea(KETTLE).replace("kettle-1", "kettle-9"), "kettle-9");
    assertThat(joined.contradiction(kettle)).isEmpty();
    Home both = joined.with(kettle).with(read(bob, withoutTea(KETTLE), "kettle-1"));

    assertThat(both.individuals().get("kettle-9").classes()).contains("Device");
  }
}
