package org.maestro.ontology.home;

import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.ontology.vocabulary.Vocabulary;
import org.maestro.sl.Formula;
import org.maestro.sl.SlParser;
import org.maestro.sl.Term;

/**
 * What a home says that persons may ask for and may not, and how far (ADE, 5; A85).
 *
 * @param name its name in the home
 * @param persons names of persons and of classes of persons; "*" is everybody, known or not
 * @param asks names of devices and of device classes; empty: all devices
 * @param permits names of features that they may ask for
 * @param forbids names of features that they may not ask for
 * @param when over the parameters of the feature, {@code ?self} the device, {@code ?speaker} the
 *     person; empty: always
 */
public record PersonalPermission(
    String name,
    Set<String> persons,
    Set<String> asks,
    Set<String> permits,
    Set<String> forbids,
    Optional<Formula> when) {
  /** The variable that stands for who asks. */
  public static final String SPEAKER = "speaker";

  /** Stands for all features. */
  static final String ANY_FEATURE = "Feature";

  /** A person is a thing that listens. */
  private static final List<String> CLASSES_OF_PERSONS = List.of("Thing", "Listener");

  public PersonalPermission {
    persons = sorted(persons);
    asks = sorted(asks);
    permits = sorted(permits);
    forbids = sorted(forbids);
  }

  /** All of a home, in the order of their names. */
  public static List<PersonalPermission> of(Home home) {
    return home.of("Permission").stream()
        .filter(PersonalPermission::isOne)
        .map(stated -> read(stated, home))
        .toList();
  }

  /** Whether a thing of a home is somebody who can ask for something. */
  public static boolean isPerson(Individual thing) {
    return thing.classes().containsAll(CLASSES_OF_PERSONS);
  }

  /** Whether all of a class are persons. */
  static boolean isOfPersons(String className, Vocabulary vocabulary) {
    return CLASSES_OF_PERSONS.stream().allMatch(wanted -> vocabulary.isA(className, wanted));
  }

  /** Whether a permission is about persons. */
  static boolean isOne(Individual stated) {
    return stated.properties().containsKey("person");
  }

  static PersonalPermission read(Individual stated, Home home) {
    return new PersonalPermission(
        stated.name(),
        Permission.names(stated, "person"),
        Permission.names(stated, "asks"),
        Permission.names(stated, "permits"),
        Permission.names(stated, "forbids"),
        stated.properties().getOrDefault("when", List.of()).stream()
            .filter(Term.Text.class::isInstance)
            .map(text -> ((Term.Text) text).value())
            .findFirst()
            .map(text -> SlParser.formula(text, home.vocabulary()::isFluent)));
  }

  /** Whether it speaks of the device. */
  public boolean isAbout(Device device) {
    return asks.isEmpty()
        || asks.contains(device.id())
        || device.individual().classes().stream().anyMatch(asks::contains);
  }

  /** Whether it says of the feature that it may be asked for; where it names none, of all. */
  public boolean permits(FeatureType feature) {
    return permits.isEmpty() && forbids.isEmpty() || covers(permits, feature);
  }

  /** Whether it says of the feature that it may not be asked for. */
  public boolean forbids(FeatureType feature) {
    return covers(forbids, feature);
  }

  private static boolean covers(Set<String> names, FeatureType feature) {
    return names.contains(feature.name()) || names.contains(ANY_FEATURE);
  }

  private static Set<String> sorted(Set<String> names) {
    return Collections.unmodifiableSet(new TreeSet<>(names));
  }
}
