package org.maestro.troubleshooting;

import com.sun.source.tree.AnnotationTree;
import com.sun.source.tree.AssertTree;
import com.sun.source.tree.BinaryTree;
import com.sun.source.tree.CompilationUnitTree;
import com.sun.source.tree.ExpressionTree;
import com.sun.source.tree.LiteralTree;
import com.sun.source.tree.MethodInvocationTree;
import com.sun.source.tree.NewClassTree;
import com.sun.source.tree.Tree;
import com.sun.source.util.TreeScanner;
import java.util.Optional;
import java.util.Set;
import java.util.SortedSet;
import java.util.TreeSet;

/**
 * All that a source file may say, each sum of texts as a whole: but not to the log, and not that
 * something cannot be.
 */
final class UnitReports extends TreeScanner<Void, Void> {
  private static final Set<String> NEVER =
      Set.of("IllegalStateException", "IllegalArgumentException", "AssertionError");

  private final SortedSet<String> texts = new TreeSet<>();

  private UnitReports() {}

  static SortedSet<String> of(CompilationUnitTree unit) {
    UnitReports reports = new UnitReports();
    reports.scan(unit, null);
    return reports.texts;
  }

  @Override
  public Void visitAnnotation(AnnotationTree annotation, Void nothing) {
    return null;
  }

  @Override
  public Void visitAssert(AssertTree check, Void nothing) {
    return null;
  }

  @Override
  public Void visitNewClass(NewClassTree made, Void nothing) {
    return NEVER.contains(made.getIdentifier().toString())
        ? null
        : super.visitNewClass(made, nothing);
  }

  @Override
  public Void visitMethodInvocation(MethodInvocationTree call, Void nothing) {
    return call.getMethodSelect().toString().startsWith("LOG.")
        ? null
        : super.visitMethodInvocation(call, nothing);
  }

  @Override
  public Void visitBinary(BinaryTree sum, Void nothing) {
    Optional<String> text = sum.getKind() == Tree.Kind.PLUS ? Wording.of(sum) : Optional.empty();
    if (text.isEmpty()) {
      return super.visitBinary(sum, nothing);
    }
    texts.add(text.get());
    operands(sum);
    return null;
  }

  /** What is put into the sum may have words of its own. */
  private void operands(ExpressionTree part) {
    if (part instanceof BinaryTree sum && sum.getKind() == Tree.Kind.PLUS) {
      operands(sum.getLeftOperand());
      operands(sum.getRightOperand());
    } else if (!(part instanceof LiteralTree)) {
      scan(part, null);
    }
  }

  @Override
  public Void visitLiteral(LiteralTree literal, Void nothing) {
    Wording.of(literal).ifPresent(texts::add);
    return null;
  }
}
