"""What a sketch keeps data in: lists, dictionaries, tables, JSON and XML; all are camelCase."""
