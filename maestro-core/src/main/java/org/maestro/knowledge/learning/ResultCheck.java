package org.maestro.knowledge.learning;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import org.maestro.ontology.floor.Pose;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.ontology.vocabulary.Parameter;
import org.maestro.sl.FreeVariables;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Term;

/** The check whether a result's outputs are what the feature's description says that they are. */
public final class ResultCheck {
  private static final Set<String> WHOLE =
      Set.of("integer", "int", "long", "short", "byte", "nonNegativeInteger", "positiveInteger");
  private static final Set<String> NUMBERS = Set.of("decimal", "double", "float");
  private static final Set<String> TEXTS = Set.of("string", "normalizedString", "token", "anyURI");

  private ResultCheck() {}

  /**
   * Why nothing can be learnt of it that the feature's lesson rests on: each output that the lesson
   * speaks of is named that is missing or is not what it should be; empty when it is as described.
   */
  public static Optional<String> objection(FeatureType feature, Map<String, Term> outputs) {
    Set<String> used = FreeVariables.of(feature.learns().orElse(feature.effect()));
    List<String> objections = new ArrayList<>();
    List<String> absent = new ArrayList<>();
    boolean any = false;
    for (Parameter output : feature.outputs()) {
      if (used.contains(output.name())) {
        Term value = outputs.get(output.name());
        any |= value != null;
        if (value == null) {
          absent.add(output.name());
          if (!output.optional()) {
            objections.add(output.name() + " is missing");
          }
        } else {
          misfit(output, value).map(what -> output.name() + " " + what).ifPresent(objections::add);
        }
      }
    }
    if (!any && objections.isEmpty() && !absent.isEmpty()) {
      objections.add(
          absent.size() == 1
              ? absent.get(0) + " is missing"
              : "all of " + String.join(", ", absent) + " are missing");
    }
    return objections.isEmpty() ? Optional.empty() : Optional.of(String.join("; ", objections));
  }

  /** The outputs without those that are not what they should be. */
  static Map<String, Term> sound(FeatureType feature, Map<String, Term> outputs) {
    Map<String, Term> sound = new TreeMap<>(outputs);
    for (Parameter output : feature.outputs()) {
      Term value = sound.get(output.name());
      if (value != null && misfit(output, value).isPresent()) {
        sound.remove(output.name());
      }
    }
    return sound;
  }

  private static Optional<String> misfit(Parameter output, Term value) {
    if (output.types().isEmpty() || output.types().stream().anyMatch(type -> fits(type, value))) {
      return Optional.empty();
    }
    List<String> wanted = output.types().stream().map(ResultCheck::words).distinct().toList();
    return Optional.of(
        "has to be " + String.join(" or ", wanted) + ", and is " + SlPrinter.print(value));
  }

  private static boolean fits(String type, Term value) {
    if (type.equals(Parameter.COVERED_SHARE)) {
      return isFinite(value) && number(value) >= 0 && number(value) <= 1;
    } else if (type.equals("Pose")) {
      return value instanceof Term.Text text && isPose(text.value());
    } else if (NUMBERS.contains(type)) {
      return isFinite(value);
    } else if (WHOLE.contains(type)) {
      return isFinite(value) && number(value) == Math.rint(number(value));
    } else if (type.equals("boolean")) {
      return value instanceof Term.Truth;
    } else if (TEXTS.contains(type)) {
      return value instanceof Term.Text;
    }
    boolean isClass = Character.isUpperCase(type.charAt(0));
    return !isClass || value instanceof Term.Name;
  }

  private static String words(String type) {
    if (type.equals(Parameter.COVERED_SHARE)) {
      return "a share from 0 to 1";
    } else if (type.equals("Pose")) {
      return "a pose such as \"1.5 2 0.8\"";
    } else if (NUMBERS.contains(type)) {
      return "a number";
    } else if (WHOLE.contains(type)) {
      return "a whole number";
    } else if (type.equals("boolean")) {
      return "true or false";
    } else if (TEXTS.contains(type)) {
      return "a text";
    }
    return "a pointer to a " + type;
  }

  private static boolean isFinite(Term value) {
    return value instanceof Term.Number && Double.isFinite(number(value));
  }

  private static double number(Term value) {
    return ((Term.Number) value).value();
  }

  private static boolean isPose(String text) {
    try {
      Pose.parse(text);
      return true;
    } catch (IllegalArgumentException e) {
      return false;
    }
  }
}
