package org.maestro.architecture;

import static org.assertj.core.api.Assertions.assertThat;

import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import com.tngtech.archunit.core.importer.ImportOption;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;

/**
 * Classes of the heart that can only be understood together are few: no cycle of dependencies has
 * more than three top-level classes, read from class files.
 */
class KnotsTest {
  private static final int MOST_CLASSES = 3;

  private static final List<String> HEART =
      List.of(
          "org.maestro.sl",
          "org.maestro.knowledge",
          "org.maestro.planning",
          "org.maestro.coordination",
          "org.maestro.agents",
          "org.maestro.platform",
          "org.maestro.rats");

  @Test
  void noCycleHasMoreThanThreeClasses() {
    JavaClasses classes =
        new ClassFileImporter()
            .withImportOption(ImportOption.Predefined.DO_NOT_INCLUDE_TESTS)
            .importPackages(HEART.toArray(String[]::new));

    assertThat(knots(uses(classes))).isEmpty();
  }

  @Test
  void aRingIsFoundAndAChainIsNone() {
    Map<String, Set<String>> uses = new TreeMap<>();
    uses.put("a", Set.of("b"));
    uses.put("b", Set.of("c"));
    uses.put("c", Set.of("d"));
    uses.put("d", Set.of());

    assertThat(knots(uses)).isEmpty();
    uses.put("d", Set.of("a", "e"));
    uses.put("e", Set.of());
    assertThat(knots(uses)).containsExactly(Set.of("a", "b", "c", "d"));
  }

  private static Map<String, Set<String>> uses(JavaClasses classes) {
    Map<String, Set<String>> uses = new TreeMap<>();
    for (JavaClass user : classes) {
      Set<String> used = uses.computeIfAbsent(topLevel(user), name -> new TreeSet<>());
      user.getDirectDependenciesFromSelf().stream()
          .map(dependency -> dependency.getTargetClass().getBaseComponentType())
          .filter(target -> HEART.stream().anyMatch(target.getPackageName()::startsWith))
          .map(KnotsTest::topLevel)
          .forEach(used::add);
    }
    return uses;
  }

  private static String topLevel(JavaClass javaClass) {
    return javaClass.getName().split("\\$")[0];
  }

  /** Sets of more than three of which each reaches each. */
  private static List<Set<String>> knots(Map<String, Set<String>> uses) {
    Map<String, Set<String>> reached = new HashMap<>();
    uses.keySet().forEach(name -> reached.put(name, reached(name, uses)));
    List<Set<String>> knots = new ArrayList<>();
    Set<String> placed = new TreeSet<>();
    for (String name : uses.keySet()) {
      Set<String> knot = new TreeSet<>(reached.get(name));
      knot.removeIf(other -> !reached.getOrDefault(other, Set.of()).contains(name));
      if (knot.size() > MOST_CLASSES && placed.addAll(knot)) {
        knots.add(knot);
      }
    }
    return knots;
  }

  private static Set<String> reached(String from, Map<String, Set<String>> uses) {
    Set<String> reached = new TreeSet<>();
    Deque<String> next = new ArrayDeque<>(List.of(from));
    while (!next.isEmpty()) {
      for (String used : uses.getOrDefault(next.poll(), Set.of())) {
        if (reached.add(used)) {
          next.add(used);
        }
      }
    }
    return reached;
  }
}
