package org.maestro.ontology.vocabulary;

import java.util.Collections;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;

/** The typed read model of a loaded vocabulary, keyed by local name. Immutable. */
public record Vocabulary(
    Map<String, ClassDeclaration> classes,
    Map<String, PredicateDeclaration> predicates,
    Map<String, FeatureType> features) {
  public Vocabulary {
    classes = Collections.unmodifiableMap(new TreeMap<>(classes));
    predicates = Collections.unmodifiableMap(new TreeMap<>(predicates));
    features = Collections.unmodifiableMap(new TreeMap<>(features));
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

  /** Whether the name is a numeric fluent's; the parser wants to know. */
  public boolean isFluent(String name) {
    return predicates.containsKey(name) && predicates.get(name).fluent();
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
