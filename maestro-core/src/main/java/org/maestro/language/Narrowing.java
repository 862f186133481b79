package org.maestro.language;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.maestro.language.chart.Reading;
import org.maestro.language.grammar.Form;
import org.maestro.language.reference.NounPhrases;
import org.maestro.language.reference.Reference;
import org.maestro.language.reference.Situation;
import org.maestro.ontology.wording.Construction;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Term;

/**
 * What could still be meant after a word: for each reading that is under way the things that may
 * fill its roles (A61). Bound to one situation.
 */
final class Narrowing {
  private static final int READINGS = 8;

  private final Situation situation;

  Narrowing(Situation situation) {
    this.situation = situation;
  }

  /** The readings, the usual ones first, each with its construction's roles. */
  List<Understanding.UnderWay> of(List<Reading> readings) {
    List<Understanding.UnderWay> found = new ArrayList<>();
    for (Reading reading : readings) {

      frame(reading.form()).stream()
          .map(this::underWay)
          .filter(one -> one.roles().values().stream().noneMatch(List::isEmpty) || isOpen(one))
          .filter(one -> !found.contains(one))
          .limit(READINGS - Math.min(READINGS, found.size()))
          .forEach(found::add);
    }
    return found;
  }

  /** Whether nothing is only supposed to follow: what is open was begun, or is a whole role. */
  static boolean isBegun(Form form) {
    boolean mayBeOpen = form.is("role") || form.is("rel") || form.is("np");
    int last = form.parts().size() - 1;
    for (int i = 0; i <= last; i++) {
      Form part = form.part(i);
      if (part.is("_") ? !mayBeOpen || i < last : !isBegun(part)) {
        return false;
      }
    }
    return true;
  }

  /** Whether what nothing is known of is of no class: a number, or words as they are. */
  private boolean isOpen(Understanding.UnderWay reading) {
    return situation.home().wording().constructions().stream()
        .filter(one -> one.name().equals(reading.construction()))
        .flatMap(one -> one.roles().stream())
        .filter(role -> reading.roles().getOrDefault(role.name(), List.of()).isEmpty())
        .noneMatch(role -> situation.home().vocabulary().classes().containsKey(role.type()));
  }

  private static List<Form> frame(Form form) {
    if (form.is("frame")) {
      return List.of(form);
    }
    return form.parts().stream().flatMap(part -> frame(part).stream()).limit(1).toList();
  }

  private Understanding.UnderWay underWay(Form frame) {
    NounPhrases phrases = new NounPhrases(situation);
    Map<String, List<String>> roles = new LinkedHashMap<>();
    List<String> said = new ArrayList<>();
    situation.home().wording().constructions().stream()
        .filter(one -> one.name().equals(frame.text(0)))
        .flatMap(one -> one.roles().stream())
        .forEach(
            role -> {
              roles.put(role.name(), candidates(phrases, frame, role));
              if (!isUnsaid(filler(frame, role))) {
                said.add(role.name());
              }
            });
    return new Understanding.UnderWay(frame.text(0), roles, said);
  }

  private static Form filler(Form frame, Construction.Role role) {
    return frame.parts().stream()
        .filter(part -> part.is("role") && part.text(0).equals(role.name()))
        .map(part -> part.part(1))
        .findFirst()
        .orElse(Form.HOLE);
  }

  /** Whether something of it is still to be said. */
  private static boolean isUnsaid(Form filler) {
    return filler.equals(Form.HOLE) || filler.parts().stream().anyMatch(Narrowing::isUnsaid);
  }

  private List<String> candidates(NounPhrases phrases, Form frame, Construction.Role role) {
    Form filler = filler(frame, role);
    if (role.type().equals(Construction.Role.CONDITION)) {
      return List.of();
    }
    boolean isRelation = role.type().equals(Construction.Role.RELATION);
    Form phrase = isRelation ? filler.part(1) : filler;
    String type =
        isRelation || !situation.home().vocabulary().classes().containsKey(role.type())
            ? ""
            : role.type();
    if (phrase.is("_") && !type.isEmpty()) {
      return names(situation.facts().individuals(type));
    }
    return names(terms(phrases.resolve(phrase, type)));
  }

  private static List<? extends Term> terms(Reference reference) {
    if (reference instanceof Reference.Single single) {
      return List.of(single.term());
    } else if (reference instanceof Reference.Several several) {
      return several.terms();
    } else if (reference instanceof Reference.Open open) {
      return open.candidates();
    }
    return List.of();
  }

  private static List<String> names(Iterable<? extends Term> terms) {
    List<String> names = new ArrayList<>();
    terms.forEach(term -> names.add(SlPrinter.print(term)));
    return names;
  }
}
