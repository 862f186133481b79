package org.maestro.troubleshooting;

import com.sun.source.tree.CompilationUnitTree;
import com.sun.source.tree.MethodTree;
import com.sun.source.tree.Tree;
import com.sun.source.tree.VariableTree;
import com.sun.source.util.TreeScanner;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** What the methods of a file do, and what its variables begin with, by their names. */
final class Declarations extends TreeScanner<Void, Void> {
  private final Map<String, List<Tree>> declared = new HashMap<>();

  private Declarations() {}

  static Map<String, List<Tree>> of(CompilationUnitTree unit) {
    Declarations declarations = new Declarations();
    declarations.scan(unit, null);
    return declarations.declared;
  }

  @Override
  public Void visitMethod(MethodTree method, Void nothing) {
    if (method.getBody() != null) {
      add(method.getName().toString(), method.getBody());
    }
    return super.visitMethod(method, nothing);
  }

  @Override
  public Void visitVariable(VariableTree variable, Void nothing) {
    if (variable.getInitializer() != null) {
      add(variable.getName().toString(), variable.getInitializer());
    }
    return super.visitVariable(variable, nothing);
  }

  private void add(String name, Tree tree) {
    declared.computeIfAbsent(name, key -> new ArrayList<>()).add(tree);
  }
}
