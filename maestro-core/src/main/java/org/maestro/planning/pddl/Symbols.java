package org.maestro.planning.pddl;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.maestro.planning.pddl.Expression.Group;
import org.maestro.planning.pddl.Expression.Position;
import org.maestro.planning.pddl.Expression.Word;

/** The symbol table of a domain and a problem: types, objects, predicates, functions. */
final class Symbols {
  static final String OBJECT = "object";

  /** A predicate or function: its number and the types of its arguments. */
  record Signature(int number, List<List<String>> types) {}

  /** A name and the types that it may be of. */
  record Typed(Word name, List<String> types) {}

  private final Map<String, List<String>> parents = new LinkedHashMap<>();
  private final Map<String, Integer> objects = new LinkedHashMap<>();
  private final List<String> names = new ArrayList<>();
  private final Map<String, BitSet> members = new LinkedHashMap<>();
  final Map<String, Signature> predicates = new LinkedHashMap<>();
  final Map<String, Signature> functions = new LinkedHashMap<>();

  Symbols() {
    parents.put(OBJECT, List.of());
  }

  void addTypes(List<Expression> items) {
    List<Typed> read = readTyped(items, false);
    for (Typed typed : read) {
      List<String> above = typed.types();
      parents.put(typed.name().text(), typed.name().text().equals(OBJECT) ? List.of() : above);
    }
    for (Typed typed : read) {
      for (String parent : typed.types()) {
        parents.putIfAbsent(parent, List.of(OBJECT));
      }
    }
  }

  void addObjects(List<Expression> items) {
    for (Typed typed : readTyped(items, false)) {
      String name = typed.name().text();
      Integer known = objects.putIfAbsent(name, objects.size());
      int number = known == null ? names.size() : known;
      if (known == null) {
        names.add(name);
      }
      for (String type : typed.types()) {
        addMember(typed.name().position(), type, number, 0);
      }
    }
  }

  private void addMember(Position position, String type, int object, int depth) {
    if (depth > parents.size()) {
      throw position.error("The type %s is below itself.".formatted(type));
    }
    List<String> above = parents(position, type);
    members.computeIfAbsent(type, absent -> new BitSet()).set(object);
    members.computeIfAbsent(OBJECT, absent -> new BitSet()).set(object);
    for (String parent : above) {
      addMember(position, parent, object, depth + 1);
    }
  }

  void checkType(Position position, String type) {
    if (!parents.containsKey(type)) {
      throw noType(position, type);
    }
  }

  private List<String> parents(Position position, String type) {
    List<String> above = parents.get(type);
    if (above == null) {
      throw noType(position, type);
    }
    return above;
  }

  private static PddlException noType(Position position, String type) {
    return position.error("There is no type %s; declare it in (:types ...).".formatted(type));
  }

  void addPredicate(Group declaration) {
    declare(predicates, declaration, "predicate");
  }

  void addFunction(Group declaration) {
    declare(functions, declaration, "function");
  }

  private void declare(Map<String, Signature> among, Group declaration, String kind) {
    if (declaration.items().isEmpty()) {
      throw declaration
          .position()
          .error("Expected a %s's name, found an empty list.".formatted(kind));
    }
    Word name = declaration.items().get(0).word("a " + kind + "'s name");
    List<List<String>> types = new ArrayList<>();
    for (Typed argument : readTyped(declaration.rest(), true)) {
      argument.types().forEach(type -> checkType(argument.name().position(), type));
      types.add(argument.types());
    }
    if (among.putIfAbsent(name.text(), new Signature(among.size(), types)) != null) {
      throw name.position().error("The %s %s is declared twice.".formatted(kind, name.text()));
    }
  }

  int object(Word word) {
    Integer number = objects.get(word.text());
    if (number == null) {
      throw word.position()
          .error("There is no object %s; declare it in (:objects ...).".formatted(word.text()));
    }
    return number;
  }

  List<String> objectNames() {
    return List.copyOf(names);
  }

  String objectName(int object) {
    return names.get(object);
  }

  /** Whether it is an object or a variable, and no number or function. */
  boolean isTerm(Expression expression) {
    return expression instanceof Word word
        && (word.isVariable()
            || !SchemaReader.isNumber(word.text()) && !functions.containsKey(word.text()));
  }

  boolean isOfType(int object, List<String> types) {
    for (String type : types) {
      if (members.containsKey(type) && members.get(type).get(object)) {
        return true;
      }
    }
    return false;
  }

  BitSet members(List<String> types) {
    BitSet all = new BitSet();
    for (String type : types) {
      all.or(members.getOrDefault(type, new BitSet()));
    }
    return all;
  }

  /** Reads {@code a b - type c - (either d e) f}. */
  List<Typed> readTyped(List<Expression> items, boolean variables) {
    List<Typed> result = new ArrayList<>();
    List<Word> waiting = new ArrayList<>();
    for (int i = 0; i < items.size(); i++) {
      Word word = items.get(i).word(variables ? "a variable" : "a name");
      boolean dash = word.text().startsWith("-");
      if (!dash) {
        if (variables != word.isVariable()) {
          throw word.position()
              .error(
                  "Expected %s, found %s."
                      .formatted(variables ? "a variable" : "a name", word.text()));
        }
        waiting.add(word);
        continue;
      }
      if (word.text().length() == 1 && ++i == items.size()) {
        throw word.position().error("Expected a type after '-', found nothing.");
      }
      List<String> types =
          word.text().length() == 1 ? types(items.get(i)) : List.of(word.text().substring(1));
      waiting.forEach(name -> result.add(new Typed(name, types)));
      waiting.clear();
    }
    waiting.forEach(name -> result.add(new Typed(name, List.of(OBJECT))));
    return result;
  }

  private static List<String> types(Expression type) {
    if (type instanceof Word word) {
      return List.of(word.text());
    }
    Group either = type.group("a type");
    if (!either.head().equals("either") || either.items().size() < 2) {
      throw either.position().error("Expected a type or (either ...).");
    }
    return either.rest().stream().map(item -> item.word("a type").text()).toList();
  }
}
