package org.maestro.ontology.validation;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** Where in a text in JSON-LD something is said, by the local names of what is described. */
final class JsonPlaces {

  private final Map<String, List<JsonText.Members>> byName = new LinkedHashMap<>();

  /** Something of this name is described there. */
  void note(String name, JsonText.Members object) {
    byName.computeIfAbsent(name, none -> new ArrayList<>()).add(object);
  }

  /** The fault with the line of what it speaks of, as far as that is plain. */
  Fault placed(Fault fault) {
    List<JsonText.Members> objects = byName.getOrDefault(fault.subject(), List.of());
    if (fault.line() > 0 || objects.size() != 1) {
      return fault;
    }
    JsonText.Members object = objects.get(0);
    String property = fault.property().substring(fault.property().lastIndexOf(':') + 1);
    List<Integer> lines = new ArrayList<>();
    object.all().stream()
        .filter(member -> isOf(member, property))
        .forEach(member -> lines.add(member.line()));
    if (lines.isEmpty() && !property.isEmpty()) {
      object.all().forEach(member -> within(member.value(), property, lines));
    }
    int line = lines.size() == 1 ? lines.get(0) : line(object);
    return new Fault(
        fault.source(), line, fault.subject(), fault.property(), fault.problem(), fault.cure());
  }

  private static void within(JsonText value, String property, List<Integer> lines) {
    for (JsonText one : value.each()) {
      if (one instanceof JsonText.Members object && object.value("id").isEmpty()) {
        for (JsonText.Member member : object.all()) {
          if (isOf(member, property)) {
            lines.add(member.line());
          }
          within(member.value(), property, lines);
        }
      }
    }
  }

  private static boolean isOf(JsonText.Member member, String property) {
    String name = member.key().substring(member.key().lastIndexOf(':') + 1);
    return Maestro.localName(name).equals(property)
        || member.key().equals("types") && property.equals("type");
  }

  /** The line of its id, or at which it begins. */
  static int line(JsonText.Members object) {
    return object.all().stream()
        .filter(member -> member.key().equals("id") || member.key().equals("@id"))
        .mapToInt(JsonText.Member::line)
        .findFirst()
        .orElse(object.line());
  }
}
