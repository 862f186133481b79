package org.maestro.language.reference;

import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.maestro.sl.Term;

/**
 * What is here, and what has to do with it now, such as the track that is played here, and the band
 * of the track. Bound to one situation; not safe for threads.
 */
final class Surroundings {
  private final Situation situation;
  private final Relations relations;
  private final Map<Term.Name, Boolean> here = new HashMap<>();

  /** Of lists that were asked for: they are the same ones, as what is found is remembered. */
  private final IdentityHashMap<List<Term.Name>, List<Term.Name>> amongThem =
      new IdentityHashMap<>();

  private Optional<List<Term.Name>> devices = Optional.empty();

  Surroundings(Situation situation, Relations relations) {
    this.situation = situation;
    this.relations = relations;
  }

  boolean isHere(Term.Name name) {
    return here.computeIfAbsent(
        name,
        one -> situation.here().filter(at -> relations.isIn(one, new Term.Name(at))).isPresent());
  }

  /** Those that are here. */
  List<Term.Name> here(List<Term.Name> among) {
    return situation.here().isEmpty()
        ? List.of()
        : amongThem.computeIfAbsent(
            among,
            all -> all.stream().filter(relations::isPlaceable).filter(this::isHere).toList());
  }

  /**
   * Those with which something here has to do now, or that has to do with what does; else all.
   *
   * @param className of which all of them are; "" for any
   */
  List<Term.Name> present(Collection<Term.Name> among, String className) {
    Set<Term.Name> near = new LinkedHashSet<>();
    devices().forEach(device -> near.addAll(relations.concernedBy(device, among, className)));
    return common(among, near)
        .or(() -> common(among, behind()))
        .orElseGet(() -> List.copyOf(among));
  }

  private static Optional<List<Term.Name>> common(
      Collection<Term.Name> among, Set<Term.Name> those) {
    List<Term.Name> both = among.stream().filter(those::contains).toList();
    return both.isEmpty() ? Optional.empty() : Optional.of(both);
  }

  /** What that names which is named by something here. */
  private Set<Term.Name> behind() {
    Set<Term.Name> named = new LinkedHashSet<>();
    devices().forEach(device -> named.addAll(relations.namedBy(device)));
    Set<Term.Name> behind = new LinkedHashSet<>();
    named.forEach(thing -> behind.addAll(relations.namedBy(thing)));
    return behind;
  }

  private List<Term.Name> devices() {
    if (devices.isEmpty()) {
      devices = Optional.of(new ArrayList<>());
      if (situation.here().isPresent()) {
        situation.facts().individuals("Device").stream()
            .filter(this::isHere)
            .forEach(devices.get()::add);
      }
    }
    return devices.get();
  }
}
