package org.maestro.ontology.home;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.ontology.vocabulary.Parameter;
import org.maestro.ontology.vocabulary.Price;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Term;

class HomeLoaderTest {

  private final Home bob = ShippedHomes.bob();

  @Test
  void readsMapAndDevicesOfBobsHome() {
    assertThat(bob.iri()).isEqualTo("https://w3id.org/maestro/home/bob");
    assertThat(bob.label()).isEqualTo("Bob's home");
    assertThat(bob.devices().keySet())
        .containsExactly(
            "cam-a", "cam-b", "lamp-a1", "lamp-a2", "lamp-b1", "lamp-b2", "lamp-b3", "lux-a",
            "lux-b", "rose");
    assertThat(bob.individuals().keySet()).contains("Bob", "Cup", "zone-a", "room-b", "door-ab");
    assertThat(bob.individuals().get("Bob").properties())
        .containsEntry("usuallyIn", List.of(new Term.Name("zone-a")));
    assertThat(bob.individuals().get("Cup").properties())
        .containsEntry("mass", List.of(new Term.Number(0.25)));
    assertThat(bob.individuals().get("door-ab").properties())
        .containsEntry("open", List.of(new Term.Truth(true)));
    assertThat(bob.individuals().get("rose").classes())
        .containsExactly("Device", "MobileRobot", "Place", "Thing");
  }

  @Test
  void givesDevicesWhatTheirClassesOffer() {
    Device camera = bob.devices().get("cam-b");
    assertThat(camera.features())
        .extracting(FeatureType::name)
        .containsExactly("observeObject", "stopObserve");
    assertThat(camera.driver()).contains("camera");
    assertThat(camera.container()).contains("cameras");
    assertThat(bob.devices().get("lamp-b1").reports())
        .containsExactly(java.util.Map.entry("level", "(= (level ?self) ?level)"));
    assertThat(bob.devices().get("rose").features())
        .extracting(FeatureType::name)
        .containsExactly("move", "pick", "place");
  }

  @Test
  void readsFeaturesWhole() {
    FeatureType observe = bob.vocabulary().features().get("observeObject");
    assertThat(observe.inputs())
        .containsExactly(
            new Parameter("object", List.of("Thing"), List.of(), List.of("colour", "size"), false));
    assertThat(observe.binds()).extracting(Parameter::name).containsExactly("zone");
    assertThat(observe.outputs())
        .extracting(Parameter::name, Parameter::types, Parameter::optional)
        .containsExactly(
            org.assertj.core.groups.Tuple.tuple("found", List.of("boolean"), false),
            org.assertj.core.groups.Tuple.tuple("pose", List.of("Pose"), true));
    assertThat(observe.continuous()).isTrue();
    assertThat(observe.endedBy()).contains("stopObserve");
    assertThat(observe.frequencyHertz()).hasValue(30);
    assertThat(observe.refersTo()).containsEntry("light", "(illuminance ?zone)");
    FeatureType measure = bob.vocabulary().features().get("measureIllumination");
    assertThat(SlPrinter.print(measure.effect()))
        .isEqualTo(
            "(and (sense (illuminance ?zone)) (forall (?p - Location)"
                + " (when (reckonedFrom ?p ?zone) (sense (illuminance ?p)))))");
    FeatureType pick = bob.vocabulary().features().get("pick");
    assertThat(pick.task()).isTrue();
    assertThat(pick.occupies()).containsExactly("arm", "base");
    assertThat(pick.exit()).contains("place");
    assertThat(pick.cost()).isInstanceOf(Price.Asked.class);
    FeatureType move = bob.vocabulary().features().get("move");
    assertThat(move.claims())
        .extracting(claim -> SlPrinter.print(claim.variable()), c -> SlPrinter.print(c.when()))
        .containsExactly(
            org.assertj.core.groups.Tuple.tuple(
                "?d - Door", "(and (side ?d ?from) (side ?d ?to) (not (= ?from ?to)))"));
    FeatureType place = bob.vocabulary().features().get("place");
    assertThat(place.inputs().get(1).types()).containsExactly("Thing", "Zone");
    FeatureType adjust = bob.vocabulary().features().get("adjustLight");
    assertThat(adjust.inputs().get(0).oneOf())
        .containsExactly(
            new Term.Number(0), new Term.Number(0.25), new Term.Number(0.5), new Term.Number(1));
  }

  @Test
  void readsPredicates() {
    var in = bob.vocabulary().predicate("in").orElseThrow();
    assertThat(in.observable()).isTrue();
    assertThat(in.functional()).isTrue();
    assertThat(in.validFor()).contains(Duration.ofMinutes(10));
    assertThat(in.validForByClass()).containsEntry("Person", Duration.ofSeconds(30));
    assertThat(in.likelyWhen().map(SlPrinter::print)).contains("(usuallyIn ?x ?p)");
    var gain = bob.vocabulary().predicate("gain").orElseThrow();
    assertThat(gain.fluent()).isTrue();
    assertThat(gain.computedBy()).contains("luxAt");
    assertThat(bob.vocabulary().predicate("luxAt").orElseThrow().computedBy()).contains("luxAt");
    assertThat(bob.vocabulary().predicate("nextTo").orElseThrow().symmetric()).isTrue();
    assertThat(bob.vocabulary().isA("TunableLamp", "Device")).isTrue();
    assertThat(bob.vocabulary().isA("MobileRobot", "Place")).isTrue();
  }

  @Test
  void addsToAClassFeatureWhatDiffers() {
    Home arena = ShippedHomes.arena();
    FeatureType adjust = arena.devices().get("lamp-3").features().get(0);
    assertThat(adjust.name()).isEqualTo("adjustLight");
    assertThat(adjust.inputs()).extracting(Parameter::name).containsExactly("level", "white");
    assertThat(adjust.inputs().get(1).optional()).isTrue();
    assertThat(adjust.inputs().get(1).oneOf()).hasSize(4);
    assertThat(adjust.precondition())
        .isEqualTo(arena.vocabulary().features().get("adjustLight").precondition());
    assertThat(arena.individuals().get("zone-3").properties())
        .containsEntry("adjoins", List.of(new Term.Name("zone-2")));
  }

  @Test
  void loadsTheSameTwice() {
    assertThat(ShippedHomes.bob()).isEqualTo(bob).hasToString(bob.toString());
  }
}
