package org.maestro.ontology.vocabulary;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Stream;

/** The typed read model of a loaded vocabulary, keyed by local name. Immutable. */
public record Vocabulary(
    Map<String, ClassDeclaration> classes,
    Map<String, PredicateDeclaration> predicates,
    Map<String, FeatureType> features) {

  public static final Vocabulary EMPTY = new Vocabulary(Map.of(), Map.of(), Map.of());

  public Vocabulary {
    classes = inOrder(classes);
    predicates = inOrder(predicates);
    features = inOrder(features);
  }

  /** In a stable order, and looked up by their hashes: facts and words are, many times a second. */
  private static <T> Map<String, T> inOrder(Map<String, T> declared) {
    return Collections.unmodifiableMap(new LinkedHashMap<>(new TreeMap<>(declared)));
  }

  public Optional<PredicateDeclaration> predicate(String name) {
    return Optional.ofNullable(predicates.get(name));
  }

  /** The IRI of the class, predicate or feature type of this name. */
  public Optional<String> iri(String name) {
    return Optional.ofNullable(classes.get(name))
        .map(ClassDeclaration::iri)
        .or(() -> predicate(name).map(PredicateDeclaration::iri))
        .or(() -> Optional.ofNullable(features.get(name)).map(FeatureType::iri));
  }

  /** This vocabulary and the other's words; of two of the same name the other's. */
  public Vocabulary with(Vocabulary other) {
    if (other.equals(EMPTY)) {
      return this;
    }
    return new Vocabulary(
        joined(classes, other.classes),
        joined(predicates, other.predicates),
        joined(features, other.features));
  }

  private static <T> Map<String, T> joined(Map<String, T> one, Map<String, T> other) {
    Map<String, T> all = new TreeMap<>(one);
    all.putAll(other);
    return all;
  }

  /**
   * A word that the other vocabulary has too, and declares otherwise: as another kind of word, or
   * with another meaning. How arguments are called, and what people read, does not count.
   */
  public Optional<String> unlike(Vocabulary other) {
    return unlike(other, Set.of());
  }

  /**
   * The same, where of some words somebody has only said that they are another's: of these what
   * kind of word it is counts, and how many arguments it has.
   */
  public Optional<String> unlike(Vocabulary other, Set<String> borrowed) {
    return other
        .names()
        .filter(name -> iri(name).isPresent())
        .filter(
            name ->
                borrowed.contains(name)
                    ? !form(name).equals(other.form(name))
                    : !comparable(name).equals(other.comparable(name)))
        .findFirst();
  }

  /** In what the other vocabulary declares the word otherwise, as part of a sentence. */
  public String difference(Vocabulary other, String name) {
    return WordDifference.between(this, other, name);
  }

  private List<Object> form(String name) {
    return Stream.of(
            Optional.ofNullable(classes.get(name)).stream().map(ClassDeclaration::iri),
            predicate(name).stream()
                .flatMap(
                    declared ->
                        Stream.of(declared.iri(), declared.fluent(), declared.parameters().size())),
            Optional.ofNullable(features.get(name)).stream())
        .<Object>flatMap(parts -> parts)
        .toList();
  }

  /** This vocabulary without these classes and predicates. */
  public Vocabulary without(Set<String> names) {
    if (names.isEmpty()) {
      return this;
    }
    Map<String, ClassDeclaration> otherClasses = new TreeMap<>(classes);
    otherClasses.keySet().removeAll(names);
    Map<String, PredicateDeclaration> otherPredicates = new TreeMap<>(predicates);
    otherPredicates.keySet().removeAll(names);
    return new Vocabulary(otherClasses, otherPredicates, features);
  }

  private Stream<String> names() {
    return Stream.of(classes, predicates, features).flatMap(words -> words.keySet().stream());
  }

  private List<Object> comparable(String name) {
    return Stream.<Optional<Object>>of(
            Optional.ofNullable(classes.get(name)).map(ClassDeclaration::unlabelled),
            Optional.ofNullable(predicates.get(name)).map(PredicateDeclaration::unlabelled),
            Optional.ofNullable(features.get(name)))
        .flatMap(Optional::stream)
        .toList();
  }

  /** Whether the name is a numeric fluent's; the parser wants to know. */
  public boolean isFluent(String name) {
    return predicates.containsKey(name) && predicates.get(name).fluent();
  }

  /** Whether something may be of both classes. */
  public boolean mayBeBoth(String one, String other) {
    return classes.keySet().stream().anyMatch(name -> isA(name, one) && isA(name, other));
  }

  /**
   * Whether the class is the ancestor or under it; a name without declaration is a class of its
   * own.
   */
  public boolean isA(String className, String ancestor) {
    ClassDeclaration declared = classes.get(className);
    return className.equals(ancestor)
        || declared != null && declared.ancestors().contains(ancestor);
  }
}
