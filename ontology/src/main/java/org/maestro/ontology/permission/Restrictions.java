package org.maestro.ontology.permission;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import org.maestro.ontology.home.Device;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.Individual;
import org.maestro.ontology.home.Permission;
import org.maestro.ontology.home.PersonalPermission;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.sl.Evaluation;
import org.maestro.sl.Facts;
import org.maestro.sl.Formula;
import org.maestro.sl.FreeVariables;
import org.maestro.sl.Substitution;
import org.maestro.sl.Term;
import org.maestro.sl.Truth;

/**
 * What the permissions of a home amount to for a person (ADE, 5; A85): who is named more narrowly
 * goes first. Immutable.
 */
public final class Restrictions {
  /** No condition at all: it may be done. */
  static final Formula ALWAYS = new Formula.And(List.of());

  /** The condition that never holds: it may not be done. */
  static final Formula NEVER = new Formula.Or(List.of());

  private final Home home;
  private final List<PersonalPermission> all;

  private Restrictions(Home home, List<PersonalPermission> all) {
    this.home = home;
    this.all = all;
  }

  public static Restrictions of(Home home) {
    return new Restrictions(home, PersonalPermission.of(home));
  }

  /** Whether nothing is said of any person. */
  public boolean areNone() {
    return all.isEmpty();
  }

  /**
   * The home as it is for somebody: what she may have done on a condition only needs that
   * condition. What she may never have done is there all the same; to that there is an {@link
   * #objection}.
   *
   * @param person empty: nobody who is known
   */
  public Home homeOf(Optional<String> person) {
    Map<String, Device> devices = new TreeMap<>(home.devices());
    devices.replaceAll((name, device) -> limited(device, person));
    return devices.equals(home.devices()) ? home : home.withDevices(devices);
  }

  private Device limited(Device device, Optional<String> person) {
    List<FeatureType> features = new ArrayList<>(device.features());
    features.replaceAll(
        feature -> {
          Formula condition = condition(person, device, feature);
          return condition.equals(ALWAYS) || condition.equals(NEVER)
              ? feature
              : feature.withPrecondition(
                  new Formula.And(List.of(feature.precondition(), condition)));
        });
    return features.equals(device.features()) ? device : device.offering(features);
  }

  /**
   * Why somebody may have the feature used in no way; empty where she may, be it on a condition.
   */
  public Optional<Objection> objection(
      Optional<String> person, Device device, FeatureType feature) {
    return condition(person, device, feature).equals(NEVER)
        ? Optional.of(
            new Objection(
                person,
                new Way(device, feature, Map.of(), ""),
                Optional.empty(),
                persons().stream()
                    .filter(other -> !condition(Optional.of(other), device, feature).equals(NEVER))
                    .toList(),
                names(person, device, feature)))
        : Optional.empty();
  }

  /**
   * Why somebody may not have the feature used with these values; what is not known to be permitted
   * is not.
   *
   * @param values of its parameters and {@code ?self}
   */
  public Optional<Objection> objection(
      Optional<String> person,
      Device device,
      FeatureType feature,
      Map<String, Term> values,
      Facts facts) {
    return isPermitted(person, device, feature, values, facts)
        ? Optional.empty()
        : Optional.of(
            new Objection(
                person,
                new Way(device, feature, values, ""),
                Optional.empty(),
                persons().stream()
                    .filter(
                        other -> isPermitted(Optional.of(other), device, feature, values, facts))
                    .toList(),
                names(person, device, feature)));
  }

  private boolean isPermitted(
      Optional<String> person,
      Device device,
      FeatureType feature,
      Map<String, Term> values,
      Facts facts) {
    return new Evaluation(facts).truth(condition(person, device, feature), values) == Truth.TRUE;
  }

  /** The names of all persons of the home. */
  List<String> persons() {
    return home.individuals().values().stream()
        .filter(PersonalPermission::isPerson)
        .map(Individual::name)
        .toList();
  }

  /** The names of the permissions by which somebody is limited in a feature. */
  public Set<String> names(Optional<String> person, Device device, FeatureType feature) {
    Set<String> names = new TreeSet<>();
    counting(person, device, feature)
        .values()
        .forEach(some -> some.forEach(permission -> names.add(permission.name())));
    return names;
  }

  /**
   * On what condition somebody may have a feature used: over its parameters and {@code ?self}.
   *
   * @param person empty: nobody who is known
   */
  Formula condition(Optional<String> person, Device device, FeatureType feature) {
    List<Formula> all = new ArrayList<>();
    for (List<PersonalPermission> some : counting(person, device, feature).values()) {
      List<Formula> allowed = new ArrayList<>();
      for (PersonalPermission one : some) {
        if (one.forbids(feature)) {
          Formula when = when(one, person, ALWAYS);
          all.add(when.equals(ALWAYS) ? NEVER : new Formula.Not(when));
        }
        if (one.permits(feature)) {
          allowed.add(when(one, person, NEVER));
        }
      }
      if (!allowed.isEmpty() && !allowed.contains(ALWAYS)) {
        all.add(allowed.size() == 1 ? allowed.get(0) : new Formula.Or(allowed));
      }
    }
    if (all.contains(NEVER)) {
      return NEVER;
    }
    return all.size() == 1 ? all.get(0) : new Formula.And(all);
  }

  /**
   * The condition of a permission.
   *
   * @param unknown stands for it where it depends on who asks, and nobody knows that
   */
  private static Formula when(PersonalPermission one, Optional<String> person, Formula unknown) {
    Formula when = one.when().orElse(ALWAYS);
    if (person.isPresent()) {
      return new Substitution(Map.of(PersonalPermission.SPEAKER, new Term.Name(person.get())))
          .apply(when);
    }
    boolean isOfWhom = FreeVariables.of(when).contains(PersonalPermission.SPEAKER);
    return isOfWhom ? unknown : when;
  }

  /** Those that count for a person, by whom they name; nobody is named more narrowly. */
  private Map<String, List<PersonalPermission>> counting(
      Optional<String> person, Device device, FeatureType feature) {
    Map<String, List<PersonalPermission>> byWhom = new LinkedHashMap<>();
    for (PersonalPermission one : all) {
      if (one.isAbout(device) && (one.permits(feature) || one.forbids(feature))) {
        for (String whom : one.persons()) {
          if (isMeant(whom, person)) {
            byWhom.computeIfAbsent(whom, name -> new ArrayList<>()).add(one);
          }
        }
      }
    }
    Set<String> whole = Set.copyOf(byWhom.keySet());
    byWhom.keySet().removeIf(whom -> whole.stream().anyMatch(one -> isNarrower(one, whom)));
    return byWhom;
  }

  private boolean isMeant(String whom, Optional<String> person) {
    return whom.equals(Permission.ANYBODY)
        || person.filter(name -> name.equals(whom) || classes(name).contains(whom)).isPresent();
  }

  private boolean isNarrower(String one, String other) {
    if (one.equals(other) || one.equals(Permission.ANYBODY)) {
      return false;
    }
    boolean isAPerson = home.individuals().containsKey(one);
    return other.equals(Permission.ANYBODY)
        || isAPerson && !home.individuals().containsKey(other)
        || !isAPerson && home.vocabulary().isA(one, other);
  }

  private Set<String> classes(String person) {
    return Optional.ofNullable(home.individuals().get(person))
        .map(Individual::classes)
        .orElse(Set.of());
  }
}
