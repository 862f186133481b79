package org.maestro.architecture;

import static org.assertj.core.api.Assertions.assertThat;

import com.tngtech.archunit.ArchConfiguration;
import com.tngtech.archunit.core.domain.AccessTarget;
import com.tngtech.archunit.core.domain.JavaAccess;
import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import com.tngtech.archunit.core.importer.ImportOption;
import java.lang.reflect.RecordComponent;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.concurrent.atomic.AtomicReference;
import org.junit.jupiter.api.Test;
import org.maestro.sim.parameters.PhysicalParameters;

/** Each number of the physics that can be set is read by something that acts. */
class NumbersOfPhysicsTest {
  @Test
  void noneIsLeftUnread() {
    List<String> unread = new ArrayList<>();
    Importing importing =
        importer ->
            importer
                .withImportOption(new ImportOption.DoNotIncludeTests())
                .importPackages("org.maestro.sim");
    collectUnread(imported(importing), PhysicalParameters.class, unread);
    assertThat(unread).isEmpty();
  }

  @Test
  void whatNobodyReadsIsFound() {
    List<String> unread = new ArrayList<>();
    collectUnread(
        imported(importer -> importer.importClasses(Example.class, Reader.class)),
        Example.class,
        unread);
    assertThat(unread).containsExactly("Example.checked", "Example.passedOn");
  }

  private record Example(double checked, double passedOn, double reckonedWith, double read) {
    Example {
      if (checked < 0) {
        throw new IllegalArgumentException("It is 0 at least.");
      }
    }

    Example reading(double other) {
      return new Example(checked, passedOn, reckonedWith, other);
    }

    double twice() {
      return 2 * reckonedWith;
    }
  }

  private record Reader(double seen) {
    static Reader of(Example example) {
      return new Reader(example.read());
    }
  }

  private interface Importing {
    JavaClasses by(ClassFileImporter importer);
  }

  /** Without what the classes know of others, which takes seconds to read. */
  private static JavaClasses imported(Importing importing) {
    AtomicReference<JavaClasses> classes = new AtomicReference<>();
    ArchConfiguration.withThreadLocalScope(
        configuration -> {
          configuration.setResolveMissingDependenciesFromClassPath(false);
          classes.set(importing.by(new ClassFileImporter()));
        });
    return classes.get();
  }

  private static void collectUnread(JavaClasses classes, Class<?> group, List<String> unread) {
    for (RecordComponent part : group.getRecordComponents()) {
      if (part.getType().isRecord()) {
        collectUnread(classes, part.getType(), unread);
      } else if (!isRead(classes, group, part)) {
        unread.add(group.getSimpleName() + "." + part.getName());
      }
    }
  }

  /** By others, or by what the record reckons of it; not to make it or another one like it. */
  private static boolean isRead(JavaClasses classes, Class<?> group, RecordComponent part) {
    return classes.stream()
        .flatMap(from -> from.getAccessesFromSelf().stream())
        .filter(access -> isOf(group, part, access.getTarget()))
        .anyMatch(access -> !access.getOriginOwner().isEquivalentTo(group) || reckons(access));
  }

  private static boolean isOf(Class<?> group, RecordComponent part, AccessTarget target) {
    return target.getOwner().isEquivalentTo(group) && target.getName().equals(part.getName());
  }

  private static boolean reckons(JavaAccess<?> access) {
    JavaClass group = access.getOriginOwner();
    return !Set.of("<init>", "toString", "equals", "hashCode")
            .contains(access.getOrigin().getName())
        && Arrays.stream(group.reflect().getRecordComponents())
            .noneMatch(part -> part.getName().equals(access.getOrigin().getName()))
        && !access.getOrigin().getRawReturnType().equals(group);
  }
}
