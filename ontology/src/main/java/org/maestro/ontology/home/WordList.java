package org.maestro.ontology.home;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.maestro.ontology.vocabulary.ClassDeclaration;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.ontology.vocabulary.PredicateDeclaration;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.TypedVariable;

/**
 * The words in which goals and questions can be put in a home: what may hold, numbers, places,
 * things, devices, what these can do, and scripts.
 */
public final class WordList {

  /** The kind of what is stated as a goal to be carried out. */
  public static final String SCRIPT = "script";

  private static final String PLACE = "Place";
  private static final String LOCATION = "Location";

  private final Home home;

  /**
   * A word.
   *
   * @param kind predicate, number, place, thing, device, feature or script
   * @param form how it is written, with its arguments
   * @param meaning what it says, or what it is
   * @param unit of a number; "" where there is none
   * @param devices that have this feature; none for other kinds
   */
  public record Entry(String kind, String form, String meaning, String unit, List<String> devices) {
    public Entry {
      devices = List.copyOf(devices);
    }

    private Entry(String kind, String form, String meaning) {
      this(kind, form, meaning, "", List.of());
    }

    /** The word alone. */
    public String name() {
      return parts()[0];
    }

    /** What it is said of, in order. */
    public List<TypedVariable> arguments() {
      String[] parts = parts();
      List<TypedVariable> arguments = new ArrayList<>();
      for (int i = 1; i < parts.length; i++) {
        boolean typed = i + 2 < parts.length && parts[i + 1].equals("-");
        arguments.add(
            new TypedVariable(
                parts[i].substring(1), typed ? Optional.of(parts[i + 2]) : Optional.empty()));
        i += typed ? 2 : 0;
      }
      return arguments;
    }

    private String[] parts() {
      return form.replaceAll("[()]", "").split(" ");
    }

    /** Whether this is the word that is called so. */
    public boolean names(String word) {
      return form.equals(word)
          || form.startsWith("(" + word + " ")
          || form.equals("(" + word + ")");
    }
  }

  private WordList(Home home) {
    this.home = home;
  }

  /** All words, by kind and then by name. */
  public static List<Entry> of(Home home) {
    WordList list = new WordList(home);
    List<Entry> entries = new ArrayList<>();
    list.predicates(false, entries);
    list.predicates(true, entries);
    home.individuals().values().stream()
        .map(list::individual)
        .sorted(
            Comparator.comparing((Entry entry) -> rank(entry.kind())).thenComparing(Entry::form))
        .forEach(entries::add);
    list.features(entries);
    home.scripts().values().forEach(script -> entries.add(entry(script)));
    return List.copyOf(entries);
  }

  private static Entry entry(Script script) {
    String worth =
        script.benefit().map(benefit -> "; worth " + SlPrinter.print(benefit)).orElse("");
    return new Entry(SCRIPT, script.form(), script.label() + worth);
  }

  private static int rank(String kind) {
    return List.of("place", "thing", "device").indexOf(kind);
  }

  private void predicates(boolean fluents, List<Entry> entries) {
    for (PredicateDeclaration predicate : home.vocabulary().predicates().values()) {
      if (predicate.fluent() == fluents) {
        String unit = predicate.unitAfterNumber();
        entries.add(
            new Entry(
                fluents ? "number" : "predicate",
                predicate.form(),
                unit.isEmpty() ? predicate.label() : predicate.label() + ", in" + unit,
                unit.strip(),
                List.of()));
      }
    }
  }

  private Entry individual(Individual individual) {
    boolean isPlace =
        individual.classes().contains(PLACE) || individual.classes().contains(LOCATION);
    String kind =
        home.devices().containsKey(individual.name()) ? "device" : isPlace ? "place" : "thing";
    String classes = String.join(", ", mostSpecial(individual.classes()));
    return new Entry(
        kind,
        individual.name(),
        individual.label().equals(individual.name())
            ? classes
            : individual.label() + ": " + classes);
  }

  private Set<String> mostSpecial(Set<String> classes) {
    Set<String> special = new TreeSet<>(classes);
    for (String name : classes) {
      ClassDeclaration declared = home.vocabulary().classes().get(name);
      if (declared != null) {
        special.removeIf(other -> !other.equals(name) && declared.ancestors().contains(other));
      }
    }
    return special;
  }

  private void features(List<Entry> entries) {
    Map<String, Set<String>> offering = new TreeMap<>();
    for (Device device : home.devices().values()) {
      device
          .features()
          .forEach(
              feature ->
                  offering
                      .computeIfAbsent(form(feature), form -> new TreeSet<>())
                      .add(device.id()));
    }
    offering.forEach(
        (form, devices) ->
            entries.add(
                new Entry(
                    "feature",
                    form,
                    "of " + String.join(", ", devices),
                    "",
                    List.copyOf(devices))));
  }

  private static String form(FeatureType feature) {
    return feature.inputs().stream()
        .map(
            input ->
                " "
                    + SlPrinter.print(
                        new TypedVariable(input.name(), input.types().stream().findFirst())))
        .collect(Collectors.joining("", "(" + feature.name(), ")"));
  }
}
