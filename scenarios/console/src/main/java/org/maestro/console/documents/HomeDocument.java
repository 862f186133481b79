package org.maestro.console.documents;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.maestro.agents.content.Words;
import org.maestro.ontology.floor.Polygon;
import org.maestro.ontology.floor.Pose;
import org.maestro.ontology.home.Device;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.Individual;
import org.maestro.sl.Term;

/** A home as it can be drawn: what it has, and where that is. */
public final class HomeDocument {
  private HomeDocument() {}

  public static JsonNode of(Home home) {
    JsonMembers document = JsonMembers.empty().text("iri", home.iri()).text("label", home.label());
    ArrayNode things = document.node().putArray("things");
    for (Individual thing : home.individuals().values()) {
      JsonMembers row =
          JsonMembers.in(things)
              .text("name", thing.name())
              .text("label", thing.label())
              .words("classes", thing.classes());
      outline(row.node(), thing);
      numbers(row.node(), "pose", text(thing, "pose"));
      numbers(row.node(), "from", text(thing, "openingFrom"));
      numbers(row.node(), "to", text(thing, "openingTo"));
      numbers(row.node(), "size", text(thing, "size"));
      number(row.node(), "viewAngle", thing);
      truth(row.node(), "open", thing);
      row.text("colour", text(thing, "colour"));
      device(row.node(), Optional.ofNullable(home.devices().get(thing.name())));
    }
    return document.node();
  }

  private static Optional<String> text(Individual thing, String property) {
    return thing.properties().getOrDefault(property, List.of()).stream()
        .findFirst()
        .map(Words::plain);
  }

  private static void outline(ObjectNode row, Individual thing) {
    row.putNull("outline");
    try {
      Optional<Polygon> outline = text(thing, "outline").map(Polygon::parse);
      if (outline.isPresent()) {
        ArrayNode corners = row.putArray("outline");
        outline
            .get()
            .corners()
            .forEach(corner -> corners.addArray().add(corner.x()).add(corner.y()));
      }
    } catch (IllegalArgumentException e) {
      row.putNull("outline");
    }
  }

  /** A maker may mean something else by the same word. */
  private static void numbers(ObjectNode row, String name, Optional<String> text) {
    row.putNull(name);
    try {
      text.map(Pose::numbers)
          .ifPresent(numbers -> Arrays.stream(numbers).forEach(row.putArray(name)::add));
    } catch (IllegalArgumentException e) {
      row.putNull(name);
    }
  }

  private static void number(ObjectNode row, String property, Individual thing) {
    Optional<Term> value =
        thing.properties().getOrDefault(property, List.of()).stream().findFirst();
    if (value.isPresent() && value.get() instanceof Term.Number number) {
      row.put(property, number.value());
    } else {
      row.putNull(property);
    }
  }

  private static void truth(ObjectNode row, String property, Individual thing) {
    Optional<Term> value =
        thing.properties().getOrDefault(property, List.of()).stream().findFirst();
    if (value.isPresent() && value.get() instanceof Term.Truth truth) {
      row.put(property, truth.value());
    } else {
      row.putNull(property);
    }
  }

  private static void device(ObjectNode row, Optional<Device> device) {
    if (device.isEmpty()) {
      row.putNull("device");
      return;
    }
    ObjectNode node = row.putObject("device");
    new JsonMembers(node).text("topic", device.get().container());
    ArrayNode features = node.putArray("features");
    device.get().features().stream()
        .map(feature -> feature.name())
        .sorted(String.CASE_INSENSITIVE_ORDER)
        .forEach(features::add);
  }
}
